// What comes of one scene: it runs, or it is refused with a reason that can be followed. Anything else is a failure.
#pragma once

#include <cstdint>
#include <string>

namespace random_scenes {

enum class Outcome { ran, refused, broke_down, failed };

struct Verdict {
    Outcome outcome = Outcome::failed;
    std::string message;  ///< of the refusal, the breakdown or the failure
};

/// Tries the scene of a seed in a process of its own, so that crashes, hangs and hunger for memory are seen too.
Verdict try_scene(std::uint64_t seed);

}  // namespace random_scenes
