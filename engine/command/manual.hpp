// The manual page sluice(1).
#pragma once

#include <string>

#include "engine/command/command_tree.hpp"

namespace sluice {

/// As `man` reads it.
std::string manual_page(const CommandNode& program, std::string_view version);

}  // namespace sluice
