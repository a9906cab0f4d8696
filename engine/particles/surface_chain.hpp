// The outline of a body on its initial lattice. A body keeps its topology, so the outline is found once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "neighbor/fields.hpp"

namespace sluice {

/// Closed loops of particle numbers along the boundary of a set of lattice sites in the plane, the material on the
/// left: counter-clockwise outside, clockwise around holes. A particle at a convex corner stands once, and particles
/// that meet across a step of the outline follow each other diagonally.
std::vector<std::vector<Index>> trace_outline(const std::vector<std::array<std::int32_t, 3>>& sites);

}  // namespace sluice
