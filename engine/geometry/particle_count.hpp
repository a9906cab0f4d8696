#pragma once

#include "engine/geometry/packing.hpp"

namespace sluice {

/// Whether `pack` would place more particles than that; places none.
bool holds_more_than(double particles, const Shape& shape, double spacing, int dimension, Fit fit = Fit::outside);

}  // namespace sluice
