// A solid needs two particles across to have a strain there.
#pragma once

#include <optional>

#include "engine/geometry/packing.hpp"

namespace sluice {

/// A place where a region is one particle thick.
struct ThinPlace {
    std::size_t particle = 0;
    std::size_t axis = 0;  ///< 0, 1, 2 = along x, y, z
    double thickness = 0;  ///< of the shape there, along that axis [m]
};

/// The first particle without lattice neighbours along some axis, if a neighbour along another axis has none either or
/// if it stands alone: the tip of a corner may be a single particle, a strip may not.
std::optional<ThinPlace> find_thin_place(const Shape& shape, const Packing& packing, int dimension);

}  // namespace sluice
