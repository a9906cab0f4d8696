// The subcommands of `sluice`.
#pragma once

#include <functional>

#include "engine/command/exit_code.hpp"

namespace CLI {
class App;
}

namespace sluice {

/// What a chosen subcommand does once the command line has been read.
using Deed = std::function<ExitCode()>;

/// `sluice run`: computes a scene.
void add_run_command(CLI::App& program, Deed& chosen);
/// `sluice check`: says what a run would do, without one.
void add_check_command(CLI::App& program, Deed& chosen);
/// `sluice help`: what the effects are.
void add_help_command(CLI::App& program, Deed& chosen);

}  // namespace sluice
