// Every column of a phase, with its name, for what treats them all alike: allocation, reordering,
// counting memory.
#pragma once

#include <string_view>

#include "engine/state/phases.hpp"

namespace sluice {

namespace detail {

template <int N, class F>
void visit_tuple(std::string_view name, TupleField<N>& field, F&& f) {
    for (auto& column : field.c) f(name, column);
}

template <int Dim, class F>
void visit_base(PhaseBase<Dim>& p, F&& f) {
    visit_tuple("position", p.position, f);
    visit_tuple("velocity", p.velocity, f);
    visit_tuple("acceleration", p.acceleration, f);
    f("density", p.density), f("density_rate", p.density_rate), f("pressure", p.pressure), f("mass", p.mass);
    f("smoothing_length", p.smoothing_length), f("id", p.id), f("body", p.body);
}

}  // namespace detail

/// f(name, Array<T>&) for each column of the phase, allocated or not; the columns of a tuple share its name.
template <int Dim, class F>
void visit_columns(FluidPhase<Dim>& p, F&& f) {
    detail::visit_base(p, f);
    f("pressure_over_rho2", p.pressure_over_rho2);
    detail::visit_tuple("velocity_correction", p.velocity_correction, f);
    f("excess_density", p.excess_density);
    detail::visit_tuple("density_gradient", p.density_gradient, f);
    detail::visit_tuple("concentration_gradient", p.surroundings.concentration_gradient, f);
    detail::visit_tuple("surface_normal", p.surroundings.surface_normal, f);
    f("position_divergence", p.surroundings.position_divergence), f("concentration", p.surroundings.concentration);
    f("surface_volume", p.surroundings.surface_volume);
}

template <int Dim, class F>
void visit_columns(SolidPhase<Dim>& p, F&& f) {
    detail::visit_base(p, f);
    detail::visit_tuple("deviatoric_stress", p.deviatoric_stress, f);
    detail::visit_tuple("stress_over_rho2", p.stress_over_rho2, f);
    detail::visit_tuple("artificial_stress", p.artificial_stress, f);
    detail::visit_tuple("velocity_gradient", p.velocity_gradient, f);
    detail::visit_tuple("velocity_correction", p.velocity_correction, f);
    detail::visit_tuple("interface_acceleration", p.interface_acceleration, f);
    detail::visit_tuple("steady_acceleration", p.steady_acceleration, f);
    detail::visit_tuple("halfway_position", p.halfway_position, f);
    detail::visit_tuple("mean_velocity", p.mean_velocity, f);
    detail::visit_tuple("mean_acceleration", p.mean_acceleration, f);
    detail::visit_tuple("reference_position", p.reference_position, f);
    detail::visit_tuple("deformation", p.deformation, f);
    detail::visit_tuple("corrected_stress", p.corrected_stress, f);
    detail::visit_tuple("gradient_correction", p.gradient_correction, f);
    f("clamped", p.clamped), f("volume", p.volume), f("hourglass_stiffness", p.hourglass_stiffness);
    f("elastic_share", p.elastic_share);
}

template <int Dim, class F>
void visit_columns(WallPhase<Dim>& p, F&& f) {
    detail::visit_tuple("position", p.position, f);
    detail::visit_tuple("initial_position", p.initial_position, f);
    detail::visit_tuple("ghost_velocity", p.ghost_velocity, f);
    f("friction_volume", p.friction_volume);
    detail::visit_tuple("velocity", p.velocity, f);
    f("pressure", p.pressure), f("volume", p.volume), f("smoothing_length", p.smoothing_length);
    f("id", p.id), f("body", p.body);
}

template <int Dim, class F>
void visit_columns(BoundaryParticles<Dim>& p, F&& f) {
    detail::visit_tuple("position", p.position, f);
    detail::visit_tuple("velocity", p.velocity, f);
    detail::visit_tuple("acceleration", p.acceleration, f);
    detail::visit_tuple("force", p.force, f);
    detail::visit_tuple("ghost_velocity", p.ghost_velocity, f);
    f("volume", p.volume), f("smoothing_length", p.smoothing_length), f("solid", p.solid), f("body", p.body);
}

template <int Dim, class F>
void visit_columns(InterfaceElements<Dim>& p, F&& f) {
    detail::visit_tuple("position", p.position, f);
    detail::visit_tuple("area_normal", p.area_normal, f);
    detail::visit_tuple("velocity", p.velocity, f);
    detail::visit_tuple("force", p.force, f);
    detail::visit_tuple("shared_force", p.shared_force, f);
    f("pressure", p.pressure), f("image_pressure", p.image_pressure), f("solid_weight", p.solid_weight);
    f("smoothing_length", p.smoothing_length), f("body", p.body);
}

/// Bytes that the phase's columns hold.
template <class Phase>
std::size_t column_bytes(const Phase& phase) {
    std::size_t bytes = 0;
    visit_columns(const_cast<Phase&>(phase),
                  [&](std::string_view, auto& column) {  // the visitor only asks for the capacity
                      bytes += column.capacity() * sizeof(column[0]);
                  });
    return bytes;
}

}  // namespace sluice
