// A dam break of any size, as a scene: water a metre high and wide at one end of a tank three metres long.
#pragma once

#include "engine/scene/scene.hpp"

namespace sluice::bench {

struct DamBreak {
    int dimension = 2;
    int particles = 10'000;  ///< about
    double h_over_d = 1.5;
    std::string precision = "double";  ///< as in a scene's [method]
};

/// Mirrored walls on all sides but the top. The water is already on its way, as it is most of the time: lists are built
/// and pruned as often as in the middle of a run, from the first step on.
Scene make_scene(const DamBreak& dam);

}  // namespace sluice::bench
