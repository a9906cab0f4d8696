#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace sluice {

/// `load_scene` from a text; `path` is for messages, and where tables are looked for. Throws SceneError.
Scene read_scene_text(const std::string& text, const std::string& path, const std::vector<std::string>& overrides = {});

}  // namespace sluice
