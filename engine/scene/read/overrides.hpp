// Changes made on the command line: `--set a.b.c=value`.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

namespace sluice {

/// Puts each `key.path=value` into the table. Throws SceneError for text that is no assignment and for bodies,
/// materials, walls, probes and constants that the file does not name; other keys are checked when the scene is read.
void apply_overrides(toml::table& root, const std::vector<std::string>& overrides, const std::string& file);

}  // namespace sluice
