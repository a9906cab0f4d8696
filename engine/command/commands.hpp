// The subcommands of `sluice`.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

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
/// `sluice bench`: measures a scene's steps against the machine.
void add_bench_command(CLI::App& program, Deed& chosen);
/// `sluice new`: writes a scene to start from.
void add_new_command(CLI::App& program, Deed& chosen);
/// `sluice help`: what scenes may say, what the effects are, the manual page, and short texts on other topics.
void add_help_command(CLI::App& program, Deed& chosen);
/// `sluice completion`: scripts for shells.
void add_completion_command(CLI::App& program, Deed& chosen);

/// `sluice study`: runs a scene over a matrix of settings.
void add_study_command(CLI::App& program, Deed& chosen);

/// `sluice view`: a page that shows a run.
void add_view_command(CLI::App& program, Deed& chosen);

/// `sluice render`: pictures and a video of a run.
void add_render_command(CLI::App& program, Deed& chosen);

/// results/NAME, where NAME is the scene file's, or its folder's if all scenes are called `scene`.
std::filesystem::path default_directory(const std::string& scene_file);

/// Those that --isa may name, here.
std::vector<std::string> isa_names();

}  // namespace sluice
