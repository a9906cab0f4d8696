// Every column of a phase, for what treats them all alike: reordering, counting memory.
#pragma once

#include "engine/state/phases.hpp"

namespace sluice {

namespace detail {

template <int N, class F>
void visit_columns(TupleField<N>& field, F&& f) {
    for (auto& column : field.c) f(column);
}

template <int Dim, class F>
void visit_base(PhaseBase<Dim>& p, F&& f) {
    visit_columns(p.position, f);
    visit_columns(p.velocity, f);
    visit_columns(p.acceleration, f);
    f(p.density), f(p.density_rate), f(p.pressure), f(p.mass), f(p.smoothing_length), f(p.id), f(p.body);
}

}  // namespace detail

/// f(Array<T>&) for each column of the phase, allocated or not.
template <int Dim, class F>
void visit_columns(FluidPhase<Dim>& p, F&& f) {
    detail::visit_base(p, f);
    f(p.pressure_over_rho2);
    detail::visit_columns(p.velocity_correction, f);
}

template <int Dim, class F>
void visit_columns(SolidPhase<Dim>& p, F&& f) {
    detail::visit_base(p, f);
    detail::visit_columns(p.deviatoric_stress, f);
    detail::visit_columns(p.stress_over_rho2, f);
    detail::visit_columns(p.artificial_stress, f);
    detail::visit_columns(p.velocity_gradient, f);
    detail::visit_columns(p.velocity_correction, f);
    detail::visit_columns(p.interface_acceleration, f);
    detail::visit_columns(p.halfway_position, f);
    detail::visit_columns(p.mean_velocity, f);
    f(p.clamped);
}

template <int Dim, class F>
void visit_columns(WallPhase<Dim>& p, F&& f) {
    detail::visit_columns(p.position, f);
    f(p.pressure), f(p.volume), f(p.smoothing_length), f(p.id), f(p.body);
}

template <int Dim, class F>
void visit_columns(InterfaceElements<Dim>& p, F&& f) {
    detail::visit_columns(p.position, f);
    detail::visit_columns(p.area_normal, f);
    detail::visit_columns(p.velocity, f);
    detail::visit_columns(p.force, f);
    detail::visit_columns(p.shared_force, f);
    f(p.pressure), f(p.image_pressure), f(p.solid_weight), f(p.smoothing_length), f(p.body);
}

/// Bytes that the phase's columns hold.
template <class Phase>
std::size_t column_bytes(const Phase& phase) {
    std::size_t bytes = 0;
    visit_columns(const_cast<Phase&>(phase), [&](auto& column) {  // the visitor only asks for the capacity
        bytes += column.capacity() * sizeof(column[0]);
    });
    return bytes;
}

}  // namespace sluice
