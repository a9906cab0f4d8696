// Scenes made up from a seed: whatever the schema offers, in combinations that nobody would think of.
#pragma once

#include <cstdint>
#include <string>

namespace random_scenes {

struct MadeUp {
    std::string text;
    bool wild = false;  ///< has nonsense in it, or a step that may be unstable
};

MadeUp make_scene(std::uint64_t seed);

}  // namespace random_scenes
