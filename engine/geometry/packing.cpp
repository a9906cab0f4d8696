#include "engine/geometry/packing.hpp"

#include <algorithm>
#include <cmath>

namespace sluice {
namespace {

double sites_along(const Bounds& bounds, std::size_t axis, double spacing) {
    return std::max(1.0, std::round((bounds.max[axis] - bounds.min[axis]) / spacing));
}

}  // namespace

double count_sites(const Shape& shape, double spacing, int dimension) {
    const Bounds bounds = shape.bounds();
    double count = 1;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) count *= sites_along(bounds, k, spacing);
    return count;
}

Packing pack(const Shape& shape, double spacing, int dimension) {
    const Bounds bounds = shape.bounds();
    Packing packing;
    packing.spacing = {1, 1, 1};
    packing.volume = 1;
    Point origin{};  // of site (0, 0, 0)
    std::array<std::int32_t, 3> count{1, 1, 1};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
        const double sites = sites_along(bounds, k, spacing);
        count[k] = static_cast<std::int32_t>(sites);
        packing.spacing[k] = (bounds.max[k] - bounds.min[k]) / sites;
        packing.volume *= packing.spacing[k];
        origin[k] = bounds.min[k] + 0.5 * packing.spacing[k];
    }
    for (std::int32_t z = 0; z < count[2]; ++z)
        for (std::int32_t y = 0; y < count[1]; ++y)
            for (std::int32_t x = 0; x < count[0]; ++x) {
                const Point p{origin[0] + x * packing.spacing[0], origin[1] + y * packing.spacing[1],
                              origin[2] + z * packing.spacing[2]};
                if (!shape.contains(p)) continue;
                packing.position.push_back(p);
                packing.site.push_back({x, y, z});
            }
    return packing;
}

}  // namespace sluice
