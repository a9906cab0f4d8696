// The rows that the table of scene keys is made of.
#pragma once

#include <span>

#include "engine/scene/table/scene_key.hpp"

namespace sluice {

/// In the order of the reference page; "effects" stands for all effects.
std::span<const SceneKey> key_rows();

}  // namespace sluice
