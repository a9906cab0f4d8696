#pragma once

#include <toml++/toml.h>

#include <string>

namespace sluice {

/// A scene as TOML without what does not matter: layout, comments, the order of keys. Bodies, materials, walls, probes
/// and constants keep their order, as particles, and with them the sums over them, follow it. References
/// are left out, as their tables stand beside the scene and not where the text goes. Read back it is the same
/// scene, with the same results to the bit.
std::string canonical_text(toml::table root);

}  // namespace sluice
