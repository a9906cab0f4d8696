#pragma once

#include <string>

#include "tests/random_scenes/random.hpp"

namespace random_scenes {

/// The text with one to three accidents: a number that is nonsense, a line gone, doubled or elsewhere, a byte too many.
std::string spoilt(std::string text, Random& random);

}  // namespace random_scenes
