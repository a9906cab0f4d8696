#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/command/commands.hpp"
#include "engine/command/scene_options.hpp"
#include "engine/command/study_text.hpp"
#include "engine/command/thread_settings.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/study/advice.hpp"
#include "engine/study/report_page.hpp"
#include "engine/study/run_study.hpp"
#include "engine/study/stored_study.hpp"
#include "engine/study/study_file.hpp"

namespace sluice {
namespace {

struct StudyArguments {
    SceneOptions scene;
    StudyOptions options;
    std::string directory;
    bool store = false;
};

/// More repeats than anyone waits for; a typing error.
constexpr int most_repeats = 1000;

void store_beside_scene(const Study& study, const std::string& scene) {
    std::filesystem::path file = study_beside(scene);
    write_atomically(file, json_text(study));
    const std::filesystem::path picture = std::filesystem::path(file).replace_extension(".svg");
    write_atomically(picture, study_svg(study));
    print(fmt::format("stored as {} and {}\n", file.string(), picture.string()));
}

ExitCode make_study(StudyArguments arguments) {
    StudyOptions& options = arguments.options;
    options.scene = arguments.scene.file;
    options.settings = arguments.scene.overrides;
    options.directory = arguments.directory;
    if (options.directory.empty()) options.directory = default_directory(options.scene).string() + "-study";
    Plan plan = make_plan(options);
    const StudyEnd end = run_study(options, plan);
    write_study(plan.study, options.directory);
    std::string text = study_table(plan.study) + "\n";
    for (const std::string& line : advice(plan.study)) text += line + "\n";
    print(text + fmt::format("measured on {}\nstudy in {}\n", machine_text(plan.study), options.directory.string()));
    if (end == StudyEnd::interrupted) {
        print("interrupted; the same command goes on where it stopped\n");
        return ExitCode::interrupted;
    }
    if (arguments.store) store_beside_scene(plan.study, options.scene);
    return ExitCode::done;
}

}  // namespace

void add_study_command(CLI::App& program, Deed& chosen) {
    CLI::App& command =
        *program.add_subcommand("study", "Run a scene over a matrix of settings: what accuracy costs in time");
    const auto arguments = std::make_shared<StudyArguments>();
    StudyOptions& options = arguments->options;
    arguments->scene.add_to(command);
    command
        .add_option(
            "--vary", options.vary,
            "Values of a key, e.g. method.spacing=0.004,0.002 or method.spacing=x2,x1,x0.5 (times the scene's); "
            "repeated: every combination")
        ->type_name("KEY=V1,V2,...")
        ->allow_extra_args(false)
        ->required();
    command.add_option("--repeat", options.repeats, "Runs of each setting, of which the median counts [1]")
        ->type_name("N")
        ->check(CLI::Range(1, most_repeats));
    command.add_option("--threads", options.threads, "Number of threads of each run [1]")
        ->type_name("N")
        ->check(CLI::Range(1, most_threads));
    command.add_option("-o,--output", arguments->directory, "Folder for the results [results/NAME OF THE SCENE-study]")
        ->type_name("DIR");
    command.add_flag("--again", options.again, "Make runs anew that are done");
    command.add_flag("--store", arguments->store,
                     "Keep the result beside the scene, for `check --target-error` and the end of `run`");
    command.callback([arguments, &chosen] { chosen = [arguments] { return make_study(*arguments); }; });
}

}  // namespace sluice
