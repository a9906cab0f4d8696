// What a scene is made of, as far as effects depend on it.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace sluice {

struct SceneContent {
    bool fluid = false, solid = false, hypoelastic = false, total_lagrangian = false, clamp = false, mirror = false,
         fixed = false, gravity = false;
    bool movable = false;  ///< a solid body that is not clamped altogether
    int total_lagrangian_bodies = 0;
    bool no_slip = false, viscous = false, moving_wall = false, driven = false, many_spacings = false;
    /// Materials of the bodies, each once.
    std::vector<std::string> fluid_materials, solid_materials;
    std::string fluids, solids, clamps, mirrors, fixed_walls, moving_walls, no_slip_walls,
        periodic_axes;  ///< names, for messages
};
SceneContent content_of(const Scene& scene);

}  // namespace sluice
