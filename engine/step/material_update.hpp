// Particle by particle: pressure from density, stress from the velocity gradient.
#pragma once

#include "engine/particles/state.hpp"

namespace sluice {

/// p and p/ρ² of the fluid from its density.
template <int Dim>
void update_fluid_pressure(State<Dim>& state);

/// p, σ/ρ² and, where `artificial_stress` e is not 0 and there is tension, R of the solid from density and S.
template <int Dim>
void update_solid_stress(State<Dim>& state, double artificial_stress);

/// The second half of a fluid's step: x += v Δt/2, ρ += dρ/dt Δt, then p and p/ρ². With acoustic damping α the pressure
/// has the part of a bulk viscosity ζ = α ρ c0 h [Sun et al. 2023], −ζ ∇·v = α c0 h dρ/dt: sound fades with the rate
/// α c0 h k²/2, shear does not, and no pass over pairs is needed. A particle that slipped through a
/// mirror plane changes places with its image, which is the same state. Returns the highest speed [m/s]; NaN if a
/// velocity is not finite.
template <int Dim>
double finish_fluid_step(State<Dim>& state, double acoustic_damping, double dt);

/// The second half of a solid's step: x += v Δt/2, ρ += dρ/dt Δt, S over the step's velocity gradient
/// (kernels/materials/jaumann.hpp), then as update_solid_stress(). Returns the highest speed likewise.
template <int Dim>
double finish_solid_step(State<Dim>& state, double artificial_stress, double dt);

}  // namespace sluice
