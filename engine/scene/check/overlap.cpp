#include "engine/scene/check/overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace sluice {
namespace {

// Particles that touch across a shared edge are half of one spacing plus half of the other apart.
constexpr double closest_share = 0.5;

Bounds grown(Bounds b, double by) {
    for (std::size_t k = 0; k < 3; ++k) {
        b.min[k] -= by;
        b.max[k] += by;
    }
    return b;
}

bool holds(const Bounds& b, const Point& p) {
    for (std::size_t k = 0; k < 3; ++k)
        if (p[k] < b.min[k] || p[k] > b.max[k]) return false;
    return true;
}

bool disjoint(const Bounds& a, const Bounds& b) {
    for (std::size_t k = 0; k < 3; ++k)
        if (a.min[k] > b.max[k] || b.min[k] > a.max[k]) return true;
    return false;
}

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
    std::size_t operator()(const Cell& c) const {
        // Large odd factors spread neighbouring cells over the table (Teschner et al. 2003).
        const auto u = [&](std::size_t k) { return static_cast<std::uint64_t>(c[k]); };
        return u(0) * 73856093u ^ u(1) * 19349663u ^ u(2) * 83492791u;
    }
};

/// Points in cells as wide as the reach of a search.
class CellHashTable {
  public:
    CellHashTable(const std::vector<Point>& points, const Bounds& region, double reach)
        : points_(points), reach_(reach) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (holds(region, points[i])) cells_[cell_of(points[i])].push_back(i);
    }
    /// The nearest point within reach, if there is one.
    const Point* nearest(const Point& p) const {
        const Point* best = nullptr;
        double least = reach_;
        const Cell centre = cell_of(p);
        for (int step = 0; step < 27; ++step) {
            const auto cell =
                cells_.find({centre[0] + step % 3 - 1, centre[1] + step / 3 % 3 - 1, centre[2] + step / 9 - 1});
            if (cell == cells_.end()) continue;
            for (const std::size_t i : cell->second) {
                const double r = distance(p, points_[i]);
                if (r >= least) continue;
                least = r;
                best = &points_[i];
            }
        }
        return best;
    }

  private:
    Cell cell_of(const Point& p) const {
        Cell c;
        for (std::size_t k = 0; k < 3; ++k) c[k] = static_cast<std::int64_t>(std::floor(p[k] / reach_));
        return c;
    }
    const std::vector<Point>& points_;
    double reach_;
    std::unordered_map<Cell, std::vector<std::size_t>, CellHash> cells_;
};

std::optional<Overlap> find_inside(const PackedRegion& a, const PackedRegion& b) {
    const Bounds bounds = b.shape->bounds();
    for (const Point& p : a.packing->position)
        if (holds(bounds, p) && b.shape->contains(p)) return Overlap{p, "a particle inside the other's shape"};
    return std::nullopt;
}

}  // namespace

std::optional<Overlap> find_overlap(const PackedRegion& a, const PackedRegion& b) {
    const double reach = closest_share * std::min(a.spacing, b.spacing);
    const Bounds near_a = grown(a.shape->bounds(), reach), near_b = grown(b.shape->bounds(), reach);
    if (disjoint(near_a, near_b)) return std::nullopt;
    if (auto inside = find_inside(a, b)) return inside;
    if (auto inside = find_inside(b, a)) return inside;
    const CellHashTable table(b.packing->position, near_a, reach);
    for (const Point& p : a.packing->position) {
        if (!holds(near_b, p)) continue;
        const Point* other = table.nearest(p);
        if (!other) continue;
        return Overlap{p, fmt::format("particles {:.3g} m apart, less than half the finer spacing of {:.3g} m",
                                      distance(p, *other), std::min(a.spacing, b.spacing))};
    }
    return std::nullopt;
}

}  // namespace sluice
