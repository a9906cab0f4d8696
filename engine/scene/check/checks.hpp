// What a scene's values cannot show one by one: whether its bodies, walls and probes fit together in space.
#pragma once

#include <vector>

#include "engine/geometry/packing.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

/// One packing per body, at its spacing. Throws SceneError for a spacing so small that particles could not be counted.
std::vector<Packing> pack_bodies(const Scene& scene);
/// One packing per wall; empty for a mirror wall.
std::vector<Packing> pack_walls(const Scene& scene);

/// Throws SceneError for bodies and fixed walls without a particle, solids thinner than two particles, overlaps, fluid
/// behind a mirror wall or outside a periodic box, periodic boxes too short for their fluid, clamps that hold nothing,
/// and displacement probes away from their body.
void check_geometry(const Scene& scene, const std::vector<Packing>& bodies, const std::vector<Packing>& walls);

/// The highest fluid speed to be expected [m/s]: method.expected_speed if the scene states it; otherwise the larger of
/// the fluid's initial speeds and sqrt(2 g H), where H is the fall from the fluid's highest point to the lowest point
/// of any body or fixed wall, or onto a mirror wall that serves as floor, whichever is longer. 0 without fluid.
double expected_fluid_speed(const Scene& scene, const std::vector<Packing>& bodies);

/// Throws SceneError if a fluid's sound speed is too low for the expected speed: the density error grows as Mach².
void check_mach(const Scene& scene, const std::vector<Packing>& bodies);

}  // namespace sluice
