// What the pair passes see of each phase.
#pragma once

#include "engine/state/phases.hpp"
#include "kernels/columns.hpp"

namespace sluice {

template <int Dim>
ParticleView<Dim> base_view(const PhaseBase<Dim>& p) {
    ParticleView<Dim> v;
    v.position = columns_of(p.position);
    v.velocity = columns_of(p.velocity);
    v.smoothing_length = p.smoothing_length.data();
    v.mass = p.mass.data();
    v.density = p.density.data();
    v.pressure = p.pressure.data();
    return v;
}

template <int Dim>
ParticleView<Dim> view_of(const FluidPhase<Dim>& p) {
    ParticleView<Dim> v = base_view(p);
    v.pressure_over_rho2 = p.pressure_over_rho2.data();
    v.density_gradient = columns_of(p.density_gradient);
    return v;
}

template <int Dim>
ParticleView<Dim> view_of(const SolidPhase<Dim>& p) {
    ParticleView<Dim> v = base_view(p);
    v.stress_over_rho2 = columns_of(p.stress_over_rho2);
    v.artificial_stress = columns_of(p.artificial_stress);
    return v;
}

/// A total-Lagrangian solid: `position` is that of the reference configuration.
template <int Dim>
ParticleView<Dim> reference_view_of(const SolidPhase<Dim>& p) {
    ParticleView<Dim> v = base_view(p);
    v.position = columns_of(p.reference_position);
    v.current_position = columns_of(p.position);
    v.volume = p.volume.data();
    v.deformation = columns_of(p.deformation);
    v.corrected_stress = columns_of(p.corrected_stress);
    v.gradient_correction = columns_of(p.gradient_correction);
    v.hourglass_stiffness = p.hourglass_stiffness.data();
    v.elastic_share = p.elastic_share.size() > 0 ? p.elastic_share.data() : nullptr;
    return v;
}

template <int Dim>
ParticleView<Dim> view_of(const WallPhase<Dim>& p) {
    ParticleView<Dim> v;
    v.position = columns_of(p.position);
    v.velocity = columns_of(p.velocity);
    v.smoothing_length = p.smoothing_length.data();
    v.volume = p.volume.data();
    v.pressure = p.pressure.data();
    return v;
}

template <int Dim>
ParticleView<Dim> view_of(const InterfaceElements<Dim>& e) {
    ParticleView<Dim> v;
    v.position = columns_of(e.position);
    v.velocity = columns_of(e.velocity);
    v.smoothing_length = e.smoothing_length.data();
    v.area_normal = columns_of(e.area_normal);
    v.shared_force = columns_of(e.shared_force);
    return v;
}

template <int Dim>
ParticleView<Dim> view_of(const BoundaryParticles<Dim>& b) {
    ParticleView<Dim> v;
    v.position = columns_of(b.position);
    v.velocity = columns_of(b.velocity);
    v.acceleration = columns_of(b.acceleration);
    v.smoothing_length = b.smoothing_length.data();
    v.volume = b.volume.data();
    return v;
}

/// The solid half-way through a step, as the interface's kinematic condition sees it.
template <int Dim>
ParticleView<Dim> halfway_view_of(const SolidPhase<Dim>& p) {
    ParticleView<Dim> v = view_of(p);
    v.position = columns_of(p.halfway_position);
    v.velocity = columns_of(p.mean_velocity);
    return v;
}

}  // namespace sluice
