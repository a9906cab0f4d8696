// Fills a shape with particles on a lattice.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/shape.hpp"

namespace sluice {

/// Lattice coordinates, from 0; z = 0 in 2D.
using Site = std::array<std::int32_t, 3>;

/// Lattice particles of one region.
struct Packing {
    std::vector<Point> position;  ///< [m]
    std::vector<Site> site;       ///< ascending in z, y, x
    Point spacing{};              ///< lattice distance along each axis [m] (z = 1 in 2D)
    double volume = 0;            ///< of one particle: the product of the spacings [m³, m² in 2D]
};

/// What a lattice fits exactly.
enum class Fit {
    outside,  ///< the shape's bounding box
    cavity    ///< the box of what is cut out of it, where that has a face inside: a tank, whose inner faces meet water
};

/// The box is divided into a whole number of sites along each axis, as near to `spacing` as can be, so that
/// a box is filled exactly; a site belongs to the packing if its centre lies in the shape.
Packing pack(const Shape& shape, double spacing, int dimension, Fit fit = Fit::outside);

/// How many sites `pack` would look at; as a real number, since a mistyped spacing can exceed any integer.
double count_sites(const Shape& shape, double spacing, int dimension, Fit fit = Fit::outside);

}  // namespace sluice
