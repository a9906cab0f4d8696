#pragma once

#include "engine/simulation/simulation.hpp"

namespace sluice {

/// Throws NumericalError, naming particle, place and time, if a particle's state is not finite or has no physical
/// meaning: faster than its medium's sound, or half or twice as dense as at rest.
template <int Dim>
void check_state(const Simulation<Dim>& simulation);

/// The same only for what is not finite.
template <int Dim>
void check_finite(const Simulation<Dim>& simulation);

}  // namespace sluice
