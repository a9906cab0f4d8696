// Which solid bodies are one from the start, and which are apart and may come into contact.
#pragma once

#include <vector>

#include "engine/geometry/packing.hpp"
#include "engine/particles/part_range.hpp"
#include "engine/particles/particle_set.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

/// A group's number for each body of the scene; no_group for fluids. Hyperelastic bodies are joined, as if glued, if
/// somewhere the gap between their surfaces is less than a quarter of a spacing. Joining is transitive. Hypoelastic
/// bodies, which stick wherever they meet, are one group.
std::vector<int> join_bodies(const Scene& scene, const std::vector<Packing>& packings);
inline constexpr int no_group = -1;

/// If groups of hyperelastic solids start within reach of each other, gives each a reference configuration to
/// itself by moving its reference positions, of which nothing but differences count. Without that they would be bound
/// to each other for good.
template <int Dim>
void part_references(const std::vector<int>& group_of_body, double reach, const PartRange& hyperelastic,
                     ParticleSet<Dim>& solid);

}  // namespace sluice
