// The JSON schema of scenes (draft 7, what TOML editors complete and check with), from the table of scene keys.
#pragma once

#include <string>

namespace sluice {

std::string scene_schema();

}  // namespace sluice
