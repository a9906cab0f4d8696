// One frame as columns: what a reader of the file sees, in an order that does not depend on memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/particles/materials.hpp"
#include "engine/particles/part_range.hpp"
#include "engine/particles/particle_set.hpp"

namespace sluice {

enum class FrameMedium : std::uint8_t { fluid = 0, solid = 1, wall = 2 };

/// A scalar per particle.
struct FrameScalar {
    std::string name;
    std::vector<float> value;
};

/// Fluid, solid and fixed wall particles, in this order; each medium sorted by id.
struct FrameTable {
    std::size_t particles = 0;
    std::vector<float> points;         ///< x, y, z of each particle [m]; z = 0 in 2D
    std::vector<float> velocity;       ///< likewise [m/s]
    std::vector<FrameScalar> scalars;  ///< pressure and density; with solids also stress and strain; NaN: no value
    std::vector<std::uint8_t> medium;  ///< FrameMedium
    std::vector<std::uint16_t> body;   ///< index into the scene's bodies, for walls into its walls
    std::vector<std::uint64_t> id;     ///< number within the medium
};

/// What it takes in memory.
std::size_t bytes_of(const FrameTable& table);

/// Ghosts are left out. Stress and Green strain of the hyperelastic particles of `solid` follow from their deformation.
template <int Dim>
FrameTable frame_table(const ParticleSet<Dim>& fluid, const ParticleSet<Dim>& solid, const ParticleSet<Dim>& wall,
                       const MaterialList& solid_materials, const PartRange& hyperelastic);

}  // namespace sluice
