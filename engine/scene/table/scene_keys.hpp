// The one table of scene keys. The reader takes types, ranges and choices from it and refuses to ask for a key that it
// lacks; `sluice help scene`, engine/SCENE.md and the JSON schema are printed from it.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "engine/scene/table/scene_key.hpp"

namespace sluice {

/// All keys, tables before what they hold, in the order of the reference page.
std::span<const SceneKey> scene_keys();

/// The row of a key in the table of this pattern ("bodies.*", "" = top level); null without one. In a table of the
/// user's own names, every key has the row of `*`.
const SceneKey* find_scene_key(std::string_view table, std::string_view key);

/// Pattern of what a value of this key holds, if it is a table or an array of them: shapes lead to "SHAPE".
std::string_view inner_pattern(const SceneKey& key);

/// The row that a path in a scene leads to: "bodies.gate.shape.union[0].box.min" to "SHAPE.box.min"; null if none.
const SceneKey* resolve_scene_key(std::string_view path);

/// All rows whose last name this is: where a misplaced key may belong.
std::vector<const SceneKey*> keys_named(std::string_view name);

}  // namespace sluice
