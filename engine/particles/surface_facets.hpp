// The faces of a 3D body on its initial lattice, and the particles that carry their corners. A body keeps its topology,
// so both are found once; engine/particles/surface.hpp derives what they are for.
#pragma once

#include <array>
#include <vector>

#include "engine/geometry/packing.hpp"
#include "neighbor/fields.hpp"

namespace sluice {

/// Weight of a particle in a corner's place.
struct CornerShare {
    Index particle;  ///< number in the packing
    double weight;
};

struct SurfaceFacets {
    /// Corners of each face, counter-clockwise seen from outside; faces in the order of their particles.
    std::vector<std::array<Index, 4>> faces;
    /// Each corner's particles. Their weights add up to 1 and reproduce the corner's place on the lattice.
    std::vector<std::vector<CornerShare>> corners;
};

/// Every side of a site's brick that no other site's brick covers. Where two parts of the body touch along an edge or
/// at a corner only, each has corners of its own.
SurfaceFacets trace_surface(const std::vector<Site>& sites);

}  // namespace sluice
