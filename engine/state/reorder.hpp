// Brings a phase's columns into another order.
#pragma once

#include "engine/state/phases.hpp"

namespace sluice {

/// One column of each type, kept between calls.
struct ReorderBuffers {
    Array<double> reals;
    Array<std::uint32_t> words;
    Array<std::uint16_t> halves;
    Array<std::uint8_t> bytes;
};

/// Particle k is then the one that was at order[k]; images are dropped.
template <int Dim>
void reorder(FluidPhase<Dim>& phase, const Array<Index>& order, ReorderBuffers& buffers);
template <int Dim>
void reorder(SolidPhase<Dim>& phase, const Array<Index>& order, ReorderBuffers& buffers);
template <int Dim>
void reorder(WallPhase<Dim>& phase, const Array<Index>& order, ReorderBuffers& buffers);

}  // namespace sluice
