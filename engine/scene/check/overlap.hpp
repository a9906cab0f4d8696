// Do two packed regions claim the same space?
#pragma once

#include <optional>
#include <string>

#include "engine/geometry/packing.hpp"

namespace sluice {

/// A region with its particles.
struct PackedRegion {
    const Shape* shape = nullptr;
    const Packing* packing = nullptr;
    double spacing = 0;  ///< nominal [m]
};

struct Overlap {
    Point place{};     ///< of a particle of one of the two [m]
    std::string what;  ///< "a particle inside the other's shape" or how close two particles are
};

/// Particles closer than half the finer spacing, or inside the other's shape. Takes time in proportion to the
/// particles.
std::optional<Overlap> find_overlap(const PackedRegion& a, const PackedRegion& b);

}  // namespace sluice
