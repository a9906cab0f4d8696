// Particle by particle: pressure from density, stress from the velocity gradient.
#pragma once

#include "engine/state/state.hpp"

namespace sluice {

/// p and p/ρ² of the fluid from its density.
template <int Dim>
void update_fluid_pressure(State<Dim>& state);

/// p, σ/ρ² and, where `artificial_stress` e is not 0 and there is tension, R of the solid from density and S.
template <int Dim>
void update_solid_stress(State<Dim>& state, double artificial_stress);

/// ρ += dρ/dt Δt for both media.
template <int Dim>
void advance_density(PhaseBase<Dim>& phase, double dt);

/// S over one step of the solid's velocity gradient (kernels/terms/jaumann.hpp).
template <int Dim>
void advance_stress(State<Dim>& state, double dt);

}  // namespace sluice
