#include "engine/geometry/packing.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/cavity.hpp"
#include "engine/geometry/particle_count.hpp"

namespace sluice {
namespace {

/// The sites along one axis.
struct Row {
    double spacing = 1, first = 0;  ///< where the first one is [m]
    double count = 1;               ///< real, since a mistyped spacing can exceed any integer
};

Row fit_between(const Interval& ends, double distance) {
    const double length = ends.to - ends.from, sites = std::max(1.0, std::round(length / distance));
    return {length / sites, ends.from + 0.5 * length / sites, sites};
}

/// A lattice that has faces half a site away from those of the cavity goes on outwards from them.
Row fit_to_cavity(const Interval& outside, const Interval& cavity, double distance) {
    const Row plain = fit_between(outside, distance);
    const double slack = 1e-9 * distance;
    const bool low = cavity.from > outside.from + slack, high = cavity.to < outside.to - slack;
    // What is narrower, as a hole for a pipe, would pull the lattice too far apart or together.
    constexpr double least_sites = 4;
    if ((!low && !high) || cavity.to - cavity.from < least_sites * distance) return plain;
    const double spacing = low && high ? fit_between(cavity, distance).spacing : plain.spacing;
    const double face = low ? cavity.from : cavity.to;
    const auto sites_within = [&](double length) { return std::floor((length + slack) / spacing + 0.5); };
    const double below = sites_within(face - outside.from), above = sites_within(outside.to - face);
    return {spacing, face + (0.5 - below) * spacing, below + above};
}

Row row_of(const Shape& shape, std::size_t axis, double distance, Fit fit) {
    const Bounds outside = shape.bounds(), cavity = fit == Fit::cavity ? cavity_of(shape) : outside;
    return fit_to_cavity({outside.min[axis], outside.max[axis]}, {cavity.min[axis], cavity.max[axis]}, distance);
}

/// The sites of a box.
struct Lattice {
    Lattice(const Shape& shape, double distance, int dimension, Fit fit) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
            const Row row = row_of(shape, k, distance, fit);
            count[k] = static_cast<std::int32_t>(row.count);
            spacing[k] = row.spacing;
            origin[k] = row.first;
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

double count_sites(const Shape& shape, double spacing, int dimension, Fit fit) {
    double count = 1;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) count *= row_of(shape, k, spacing, fit).count;
    return count;
}

Packing pack(const Shape& shape, double spacing, int dimension, Fit fit) {
    const Lattice lattice(shape, spacing, dimension, fit);
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

bool holds_more_than(double particles, const Shape& shape, double spacing, int dimension, Fit fit) {
    double found = 0;
    Lattice(shape, spacing, dimension, fit).visit([&](const Point& p, const Site&) {
        found += shape.contains(p);
        return found <= particles;
    });
    return found > particles;
}

}  // namespace sluice
