#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/command/commands.hpp"
#include "engine/command/scene_options.hpp"
#include "engine/command/thread_settings.hpp"
#include "engine/run.hpp"
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
};

std::vector<std::string> isa_names() {
    std::vector<std::string> names;
    for (const Isa isa : available_isas()) names.emplace_back(name_of(isa));
    return names;
}

ExitCode run_scene(const RunArguments& arguments) {
    use_thread_settings(arguments.threads);
    if (!arguments.isa.empty()) use_isa(arguments.isa);
    const Scene scene = load_scene(arguments.scene.file, arguments.scene.overrides);
    std::filesystem::path directory = arguments.directory;
    if (directory.empty()) directory = default_directory(arguments.scene.file);
    const RunStatus status = run(scene, {directory, arguments.threads, arguments.until});
    if (status.state == RunState::failed) print_error(status.message);
    const std::string expected = status.state == RunState::done && !arguments.until ? expectation_text(scene) : "";
    print(status.report + expected + "results in " + directory.string() + "\n");
    switch (status.state) {
        case RunState::failed:
            return ExitCode::numerical_failure;
        case RunState::interrupted:
            return ExitCode::interrupted;
        default:
            return ExitCode::done;
    }
}

}  // namespace

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
    command.add_option("-o,--output", arguments->directory, "Folder for the results [results/NAME OF THE SCENE]")
        ->type_name("DIR");
    command.add_option("--threads", arguments->threads, "Number of threads [all]")
        ->type_name("N")
        ->check(CLI::Range(1, most_threads));
    command.add_option("--until", arguments->until, "Simulated time to run to, in place of the scene's [s]")
        ->type_name("T")
        ->check(CLI::PositiveNumber);
    command.add_option("--isa", arguments->isa, "Instruction set of the loops over pairs [the best that runs here]")
        ->check(CLI::IsMember(isa_names()));
    command.callback([arguments, &chosen] { chosen = [arguments] { return run_scene(*arguments); }; });
}

}  // namespace sluice
