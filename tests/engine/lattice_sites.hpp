// How large a scene would be, before it is placed: what tests of made-up scenes go by.
#pragma once

#include "engine/geometry/packing.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

/// Of the lattices that bodies and fixed walls are cut from.
inline double lattice_sites(const Scene& scene) {
    double sites = 0;
    for (const Body& body : scene.bodies) sites += count_sites(*body.shape, body.spacing, scene.dimension);
    for (const Wall& wall : scene.walls)
        if (wall.kind == WallKind::fixed) sites += count_sites(*wall.shape, wall.spacing, scene.dimension, Fit::cavity);
    return sites;
}

}  // namespace sluice
