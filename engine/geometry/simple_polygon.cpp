#include "engine/geometry/simple_polygon.hpp"

#include <algorithm>

namespace sluice {
namespace {

/// Twice the signed area of the triangle abc.
double turn(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

int sign(double v) { return (v > 0) - (v < 0); }

bool in_box(const Point& p, const Point& a, const Point& b) {
    return std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) && std::min(a[1], b[1]) <= p[1] &&
           p[1] <= std::max(a[1], b[1]);
}

/// Do the closed segments ab and cd share a point?
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const int abc = sign(turn(a, b, c)), abd = sign(turn(a, b, d));
    const int cda = sign(turn(c, d, a)), cdb = sign(turn(c, d, b));
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && in_box(c, a, b)) || (abd == 0 && in_box(d, a, b)) || (cda == 0 && in_box(a, c, d)) ||
           (cdb == 0 && in_box(b, c, d));
}

}  // namespace

double polygon_area(const std::vector<Point>& vertices) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i) twice += turn(vertices[0], vertices[i], vertices[i + 1]);
    return 0.5 * twice;
}

std::optional<std::pair<std::size_t, std::size_t>> find_crossing_edges(const std::vector<Point>& vertices) {
    const std::size_t n = vertices.size();
    const auto vertex = [&](std::size_t i) -> const Point& { return vertices[i % n]; };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j == n - 1) continue;  // the last edge and the first share vertex 0
            if (segments_meet(vertex(i), vertex(i + 1), vertex(j), vertex(j + 1))) return std::pair{i, j};
        }
    return std::nullopt;
}

}  // namespace sluice
