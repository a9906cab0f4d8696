// Brings a phase's particles into another order.
#pragma once

#include "engine/state/phases.hpp"

namespace sluice {

/// Particle k becomes what particle order[k] was, in every allocated field. Images are dropped.
template <int Dim>
void reorder(FluidPhase<Dim>& phase, const Array<Index>& order);
template <int Dim>
void reorder(SolidPhase<Dim>& phase, const Array<Index>& order);

}  // namespace sluice
