// Brings a phase's columns into another order.
#pragma once

#include "engine/state/phases.hpp"

namespace sluice {

/// Particle k is then the one that was at order[k]; images are dropped.
template <int Dim>
void reorder(FluidPhase<Dim>& phase, const Array<Index>& order);
template <int Dim>
void reorder(SolidPhase<Dim>& phase, const Array<Index>& order);
template <int Dim>
void reorder(WallPhase<Dim>& phase, const Array<Index>& order);

}  // namespace sluice
