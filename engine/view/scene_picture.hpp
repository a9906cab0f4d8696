// What a scene puts where, before it runs: particles by body, clamps, walls, probes, periodic sides.
#pragma once

#include <string>

#include "engine/scene/scene.hpp"

namespace sluice {

/// As PNG. Draws a scene that the checks would refuse too, so that one sees why. Throws SceneError for a spacing so
/// small that particles could not be counted.
std::string scene_picture(const Scene& scene);

}  // namespace sluice
