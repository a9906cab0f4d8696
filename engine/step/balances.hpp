// What a state holds as a whole: energy, momentum, highest speed. Sums do not depend on the number of threads.
#pragma once

#include "engine/particles/state.hpp"
#include "engine/step/energy_balance.hpp"

namespace sluice {

/// Kinetic, potential (−m g·x), compression (∫p/ρ² dρ) and elastic (S:S/4μ) energy of all moving particles.
template <int Dim>
EnergyBalance energy_of(const State<Dim>& state);

/// Σ m v of all moving particles.
template <int Dim>
Vec<Dim> momentum_of(const State<Dim>& state);

/// Highest |v| of a phase [m/s]; NaN if any is not finite.
template <int Dim>
double highest_speed(const ParticleSet<Dim>& phase);

}  // namespace sluice
