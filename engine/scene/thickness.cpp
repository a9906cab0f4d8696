#include "engine/scene/thickness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sluice {
namespace {

using Site = std::array<std::int32_t, 3>;

Site moved(Site site, std::size_t axis, std::int32_t by) {
    site[axis] += by;
    return site;
}

/// Which lattice sites hold a particle.
class Occupancy {
  public:
    explicit Occupancy(const Packing& packing) {
        for (const Site& s : packing.site)
            for (std::size_t k = 0; k < 3; ++k) size_[k] = std::max(size_[k], s[k] + 1);
        taken_.resize(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]);
        for (const Site& s : packing.site) taken_[index(s)] = true;
    }
    bool operator()(const Site& s) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (s[k] < 0 || s[k] >= size_[k]) return false;
        return taken_[index(s)];
    }

  private:
    std::size_t index(const Site& s) const {
        return (static_cast<std::size_t>(s[2]) * size_[1] + s[1]) * size_[0] + s[0];
    }
    Site size_{};
    std::vector<bool> taken_;
};

bool lacks_neighbours(const Occupancy& taken, const Site& site, std::size_t axis) {
    return !taken(moved(site, axis, -1)) && !taken(moved(site, axis, 1));
}

bool is_thin(const Occupancy& taken, const Site& site, std::size_t axis, std::size_t dimension) {
    if (!lacks_neighbours(taken, site, axis)) return false;
    bool alone = true;
    for (std::size_t other = 0; other < dimension; ++other) {
        if (other == axis) continue;
        for (const std::int32_t step : {-1, 1}) {
            const Site next = moved(site, other, step);
            if (!taken(next)) continue;
            if (lacks_neighbours(taken, next, axis)) return true;
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
    const Occupancy taken(packing);
    const auto axes = static_cast<std::size_t>(dimension);
    for (std::size_t i = 0; i < packing.site.size(); ++i)
        for (std::size_t axis = 0; axis < axes; ++axis) {
            if (!is_thin(taken, packing.site[i], axis, axes)) continue;
            const double d = packing.spacing[axis];
            const double thickness =
                reach(shape, packing.position[i], axis, d) + reach(shape, packing.position[i], axis, -d);
            return ThinPlace{i, axis, thickness};
        }
    return std::nullopt;
}

}  // namespace sluice
