// Is a chain of vertices a polygon with an inside?
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/geometry/shape.hpp"

namespace sluice {

/// Signed area in the xy-plane, positive if the vertices run anticlockwise. [m²]
double polygon_area(const std::vector<Point>& vertices);

/// Two edges that meet other than at a vertex they share; edge i runs from vertex i to the next. None = simple polygon.
std::optional<std::pair<std::size_t, std::size_t>> find_crossing_edges(const std::vector<Point>& vertices);

}  // namespace sluice
