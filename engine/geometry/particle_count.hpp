#pragma once

#include "engine/geometry/shape.hpp"

namespace sluice {

/// Whether `pack` (packing.hpp) would place more particles than that; places none.
bool holds_more_than(double particles, const Shape& shape, double spacing, int dimension);

}  // namespace sluice
