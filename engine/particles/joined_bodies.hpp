// Decides which solid bodies are joined from the start; the others may come into contact.
#pragma once

#include <vector>

#include "engine/geometry/packing.hpp"
#include "engine/particles/part_range.hpp"
#include "engine/particles/particle_set.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

/// Returns the number of each body's group; no_group for fluids. Hyperelastic bodies are joined, as if glued, if the
/// gap between their surfaces is less than a quarter of a spacing anywhere. Joining is transitive. All hypoelastic
/// bodies are one group, as they stick wherever they meet.
std::vector<int> join_bodies(const Scene& scene, const std::vector<Packing>& packings);
inline constexpr int no_group = -1;

/// Moves the reference positions of each group of hyperelastic solids out of the others' reach, if any start within it;
/// otherwise they would be neighbours, and so bound to each other, for good. Only differences of reference positions
/// within a group count.
template <int Dim>
void part_references(const std::vector<int>& group_of_body, double reach, const PartRange& hyperelastic,
                     ParticleSet<Dim>& solid);

}  // namespace sluice
