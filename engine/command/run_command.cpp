#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/errors.hpp"
#include "engine/base/version.hpp"
#include "engine/command/commands.hpp"
#include "engine/command/scene_options.hpp"
#include "engine/command/thread_settings.hpp"
#include "engine/run/profile/trace_recorder.hpp"
#include "engine/run/resume.hpp"
#include "engine/run/run.hpp"
#include "engine/scene/check/suspicion.hpp"
#include "engine/study/stored_study.hpp"
#include "neighbor/isa.hpp"

namespace sluice {
namespace {

struct RunArguments {
    SceneOptions scene;
    std::string directory;
    int threads = 0;
    std::optional<double> until;
    std::string isa;
    std::string resume;  ///< folder of the run to go on with
    bool force = false;
    bool profile = false;
    int traced_steps = 20;

    std::optional<int> profiled_steps() const { return profile ? std::optional(traced_steps) : std::nullopt; }
};

/// What is told when a run ends. `expected`: of a whole run's results.
ExitCode report(const RunStatus& status, const std::string& expected, const std::filesystem::path& directory) {
    if (status.state == RunState::failed) print_error(status.message);
    print(status.report + (status.state == RunState::done ? expected : "") + "results in " + directory.string() + "\n");
    switch (status.state) {
        case RunState::failed:
            return ExitCode::numerical_failure;
        case RunState::interrupted:
            return ExitCode::interrupted;
        case RunState::running:
        case RunState::done:
            break;
    }
    return ExitCode::done;
}

ExitCode run_scene(const RunArguments& arguments) {
    use_thread_settings(arguments.threads);
    if (!arguments.isa.empty()) use_isa(arguments.isa);
    const Scene scene = load_scene(arguments.scene.file, arguments.scene.overrides);
    for (const std::string& doubt : suspicious_values(scene)) print_warning(doubt);
    std::filesystem::path directory = arguments.directory;
    if (directory.empty()) directory = default_directory(arguments.scene.file);
    return report(run(scene, {directory, arguments.threads, arguments.until, {}, stderr, arguments.profiled_steps()}),
                  arguments.until ? "" : expectation_text(scene), directory);
}

/// Another instruction set, or another program, adds up in another way: said, as results then are no longer the same
/// bits.
void follow_label(const CheckpointLabel& label, const std::string& isa) {
    const auto tell = [](const std::string& what, std::string_view then, std::string_view now) {
        if (then != now)
            print_warning(
                fmt::format("the checkpoint was written with {} {}, this is {}: the results may differ in "
                            "their last bits from those of an uninterrupted run",
                            what, then, now));
    };
    const std::vector<std::string> names = isa_names();
    const bool available = std::find(names.begin(), names.end(), label.instruction_set) != names.end();
    if (!isa.empty() || available) use_isa(isa.empty() ? label.instruction_set : isa);
    tell("instruction set", label.instruction_set, name_of(active_isa()));
    tell("version", label.program_version, program_version());
}

/// The scene beside the checkpoints if no other is given. Throws CheckpointError if it has changed, unless forced.
Scene scene_to_resume(const RunArguments& arguments, const ResumePoint& point) {
    const std::filesystem::path kept = std::filesystem::path(arguments.resume) / "scene.toml";
    const std::string file = arguments.scene.file.empty() ? kept.string() : arguments.scene.file;
    Scene scene = load_scene(file, arguments.scene.overrides);
    const std::string changes = scene_changes(point, scene);
    const std::string text =
        fmt::format("{}: the scene is not that of {}:\n{}", file, point.checkpoint.string(), changes);
    if (!changes.empty() && !arguments.force) throw CheckpointError(text + "--force goes on with it all the same");
    if (!changes.empty()) print_warning(text + "going on with it all the same");
    scene.file = point.label.scene_file;  // as the run was given it
    return scene;
}

ExitCode resume_run(const RunArguments& arguments) {
    use_thread_settings(arguments.threads);
    const std::filesystem::path directory = arguments.resume;
    const std::optional<double> finished = finished_at(directory);
    if (finished && arguments.until.value_or(*finished) <= *finished) {
        print(fmt::format("{} is finished: it ran to {:.6g} s; --until goes on from its last checkpoint\n",
                          directory.string(), *finished));
        return ExitCode::done;
    }
    const ResumePoint point = find_resume_point(directory);
    for (const std::string& warning : point.warnings) print_warning(warning + "; the one before is used");
    follow_label(point.label, arguments.isa);
    const Scene scene = scene_to_resume(arguments, point);
    print_note(fmt::format("going on from {}: step {}, {:.6g} s", point.checkpoint.string(), point.label.step,
                           point.label.time));
    const double until = arguments.until.value_or(point.label.end_time);
    return report(
        run(scene, {directory, arguments.threads, until, point.checkpoint, stderr, arguments.profiled_steps()}),
        arguments.until ? "" : expectation_text(scene), directory);
}

}  // namespace

std::vector<std::string> isa_names() {
    std::vector<std::string> names;
    for (const Isa isa : available_isas()) names.emplace_back(name_of(isa));
    return names;
}

std::filesystem::path default_directory(const std::string& scene_file) {
    const std::filesystem::path file = std::filesystem::absolute(scene_file).lexically_normal();
    const std::filesystem::path folder = file.parent_path().filename();
    const bool by_folder = file.stem() == "scene" && !folder.empty();
    return std::filesystem::path("results") / (by_folder ? folder : file.stem());
}

void add_run_command(CLI::App& program, Deed& chosen) {
    CLI::App& command = *program.add_subcommand("run", "Compute a scene");
    const auto arguments = std::make_shared<RunArguments>();
    arguments->scene.add_to(command);
    CLI::Option* scene = command.get_option("SCENE")->required(false);
    CLI::Option* output =
        command.add_option("-o,--output", arguments->directory, "Folder for the results [results/NAME OF THE SCENE]")
            ->type_name("DIR");
    CLI::Option* resume =
        command
            .add_option("--resume", arguments->resume,
                        "Go on with the stopped run in this folder, from its last checkpoint; SCENE may be left out")
            ->type_name("DIR")
            ->excludes(output);
    command.add_flag("--force", arguments->force, "With --resume: go on even if the scene has been changed")
        ->needs(resume);
    command.add_option("--threads", arguments->threads, "Number of threads [all]")
        ->type_name("N")
        ->check(CLI::Range(1, most_threads));
    command.add_option("--until", arguments->until, "Simulated time to run to, in place of the scene's [s]")
        ->type_name("T")
        ->check(CLI::PositiveNumber);
    command.add_option("--isa", arguments->isa, "Instruction set of the loops over pairs [the best that runs here]")
        ->check(CLI::IsMember(isa_names()));
    CLI::Option* profile = command.add_flag("--profile", arguments->profile,
                                            "Say where the time goes: a table, profile.json and trace.json");
    command
        .add_option("--trace-steps", arguments->traced_steps,
                    "With --profile: steps in trace.json, evenly spaced over the run [20]")
        ->type_name("N")
        ->check(CLI::Range(0, most_traced_steps))
        ->needs(profile);
    command.callback([arguments, scene, resume, &chosen] {
        if (scene->empty() && resume->empty()) throw CLI::RequiredError("SCENE");
        const bool resumed = !resume->empty();
        chosen = [arguments, resumed] { return resumed ? resume_run(*arguments) : run_scene(*arguments); };
    });
}

}  // namespace sluice
