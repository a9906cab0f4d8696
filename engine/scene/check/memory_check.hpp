// Whether a scene fits into memory.
#pragma once

#include <vector>

#include "engine/geometry/packing.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

/// What this process may still take: of the machine's memory, and of its own limit (ulimit -v). [bytes]
double available_memory();

/// How many particles fit into so many bytes, of the scene's dimension.
double particles_in(double bytes, int dimension);

/// Throws SceneError if the particles' columns and neighbour lists alone would take more than there is.
void check_memory(const Scene& scene, const std::vector<Packing>& bodies, const std::vector<Packing>& walls,
                  double available);

}  // namespace sluice
