// Scripts with which shells complete the command line.
#pragma once

#include <string>

#include "engine/command/command_tree.hpp"

namespace sluice {

std::string bash_completion(const CommandNode& program);
std::string zsh_completion(const CommandNode& program);
std::string fish_completion(const CommandNode& program);

}  // namespace sluice
