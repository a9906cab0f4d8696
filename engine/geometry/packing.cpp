#include "engine/geometry/packing.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/particle_count.hpp"

namespace sluice {
namespace {

double sites_along(const Bounds& bounds, std::size_t axis, double spacing) {
    return std::max(1.0, std::round((bounds.max[axis] - bounds.min[axis]) / spacing));
}

/// The sites of a bounding box.
struct Lattice {
    Lattice(const Bounds& bounds, double distance, int dimension) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
            const double sites = sites_along(bounds, k, distance);
            count[k] = static_cast<std::int32_t>(sites);
            spacing[k] = (bounds.max[k] - bounds.min[k]) / sites;
            origin[k] = bounds.min[k] + 0.5 * spacing[k];
        }
    }
    /// action(place, site), ascending in z, y, x, until one returns false.
    template <class Action>
    void visit(Action&& action) const {
        for (std::int32_t z = 0; z < count[2]; ++z)
            for (std::int32_t y = 0; y < count[1]; ++y)
                for (std::int32_t x = 0; x < count[0]; ++x) {
                    const Point p{origin[0] + x * spacing[0], origin[1] + y * spacing[1], origin[2] + z * spacing[2]};
                    if (!action(p, Site{x, y, z})) return;
                }
    }

    Point spacing{1, 1, 1};
    Point origin{};  ///< of site (0, 0, 0)
    std::array<std::int32_t, 3> count{1, 1, 1};
};

}  // namespace

double count_sites(const Shape& shape, double spacing, int dimension) {
    const Bounds bounds = shape.bounds();
    double count = 1;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) count *= sites_along(bounds, k, spacing);
    return count;
}

Packing pack(const Shape& shape, double spacing, int dimension) {
    const Lattice lattice(shape.bounds(), spacing, dimension);
    Packing packing;
    packing.spacing = lattice.spacing;
    packing.volume = lattice.spacing[0] * lattice.spacing[1] * lattice.spacing[2];
    lattice.visit([&](const Point& p, const Site& site) {
        if (!shape.contains(p)) return true;
        packing.position.push_back(p);
        packing.site.push_back(site);
        return true;
    });
    return packing;
}

bool holds_more_than(double particles, const Shape& shape, double spacing, int dimension) {
    double found = 0;
    Lattice(shape.bounds(), spacing, dimension).visit([&](const Point& p, const Site&) {
        found += shape.contains(p);
        return found <= particles;
    });
    return found > particles;
}

}  // namespace sluice
