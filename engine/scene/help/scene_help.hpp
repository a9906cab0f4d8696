// What a scene may say, in words: printed from the table of scene keys, so that it says what the reader takes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/table/scene_key.hpp"

namespace sluice {

/// Every key in a line, table by table.
std::string scene_key_list();

/// One key: what it is, its values, what holds without it, when it applies. Of a table also the keys in it.
std::string scene_key_page(const SceneKey& key);

/// The rows that a user may mean: a path as in a scene or in the list, or the last name of one. Empty if none.
std::vector<const SceneKey*> meant_scene_keys(std::string_view text);

/// Paths and last names of all keys, of which the nearest to a slip is told.
std::vector<std::string> scene_key_names();

/// All of it as Markdown: engine/SCENE.md.
std::string scene_document();

}  // namespace sluice
