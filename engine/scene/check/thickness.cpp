#include "engine/scene/check/thickness.hpp"

#include <cmath>

#include "engine/geometry/site_index.hpp"

namespace sluice {
namespace {

bool lacks_neighbours(const SiteIndex& lattice, const Site& site, std::size_t axis) {
    return !lattice.taken(moved(site, axis, -1)) && !lattice.taken(moved(site, axis, 1));
}

bool is_thin(const SiteIndex& lattice, const Site& site, std::size_t axis, std::size_t dimension) {
    if (!lacks_neighbours(lattice, site, axis)) return false;
    bool alone = true;
    for (std::size_t other = 0; other < dimension; ++other) {
        if (other == axis) continue;
        for (const std::int32_t step : {-1, 1}) {
            const Site next = moved(site, other, step);
            if (!lattice.taken(next)) continue;
            if (lacks_neighbours(lattice, next, axis)) return true;
            alone = false;
        }
    }
    return alone;
}

/// How far the shape reaches from p in one direction along an axis.
double reach(const Shape& shape, const Point& p, std::size_t axis, double step) {
    const auto inside = [&](double distance) {
        Point q = p;
        q[axis] += distance;
        return shape.contains(q);
    };
    // Without a lattice neighbour the edge is nearer than one spacing, unless a gap lies between two sites.
    double in = 0, out = step;
    for (int halving = 0; halving < 24; ++halving) {
        const double middle = 0.5 * (in + out);
        (inside(middle) ? in : out) = middle;
    }
    return std::abs(in);
}

}  // namespace

std::optional<ThinPlace> find_thin_place(const Shape& shape, const Packing& packing, int dimension) {
    const SiteIndex lattice(packing.site);
    const auto axes = static_cast<std::size_t>(dimension);
    for (std::size_t i = 0; i < packing.site.size(); ++i)
        for (std::size_t axis = 0; axis < axes; ++axis) {
            if (!is_thin(lattice, packing.site[i], axis, axes)) continue;
            const double d = packing.spacing[axis];
            const double thickness =
                reach(shape, packing.position[i], axis, d) + reach(shape, packing.position[i], axis, -d);
            return ThinPlace{i, axis, thickness};
        }
    return std::nullopt;
}

}  // namespace sluice
