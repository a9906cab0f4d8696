#pragma once

#include "engine/geometry/shape.hpp"

namespace sluice {

/// The box around all that a difference cuts out of its base; the shape's own box if it cuts nothing.
Bounds cavity_of(const Shape& shape);

}  // namespace sluice
