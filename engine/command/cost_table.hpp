// What a scene and its effects cost, for people.
#pragma once

#include <string>

#include "engine/run/profile/cost.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

/// 0.45 s, 45 s, 12 min, 3.5 h, 2.1 days
std::string duration_text(double seconds);

/// `end`: simulated time of the whole run [s]
std::string cost_text(const SceneCost& cost, double end);

}  // namespace sluice
