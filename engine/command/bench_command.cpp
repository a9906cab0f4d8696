#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "engine/command/commands.hpp"
#include "engine/command/scene_options.hpp"
#include "engine/command/thread_settings.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/run/profile/scene_bench.hpp"
#include "engine/scene/check/suspicion.hpp"
#include "neighbor/isa.hpp"
#include "neighbor/thread_count.hpp"

namespace sluice {
namespace {

struct BenchArguments {
    SceneOptions scene;
    double seconds = 12;
    int threads = 0;
    std::string isa;
    std::string json;  ///< file
};

ExitCode run_bench(const BenchArguments& arguments) {
    use_thread_settings(arguments.threads);
    if (!arguments.isa.empty()) use_isa(arguments.isa);
    if (arguments.threads > 0) omp_set_num_threads(arguments.threads);
    const Scene scene = load_scene(arguments.scene.file, arguments.scene.overrides);
    for (const std::string& doubt : suspicious_values(scene)) print_warning(doubt);
    const SceneBench bench =
        scene.dimension == 2 ? bench_scene<2>(scene, arguments.seconds) : bench_scene<3>(scene, arguments.seconds);
    const Effects effects(scene);
    if (!arguments.json.empty()) write_atomically(arguments.json, bench_json(bench, scene, effects));
    print(bench_text(bench, scene, effects));
    return ExitCode::done;
}

}  // namespace

void add_bench_command(CLI::App& program, Deed& chosen) {
    CLI::App& command = *program.add_subcommand("bench", "Measure a scene's steps against what this machine can do");
    const auto arguments = std::make_shared<BenchArguments>();
    arguments->scene.add_to(command);
    command.add_option("--seconds", arguments->seconds, "How long to measure, in about [12]")
        ->type_name("S")
        ->check(CLI::Range(0.1, 3600.0));
    command.add_option("--threads", arguments->threads, "Number of threads to compare with one [all]")
        ->type_name("N")
        ->check(CLI::Range(1, most_threads));
    command.add_option("--isa", arguments->isa, "Instruction set of the loops over pairs [the best that runs here]")
        ->check(CLI::IsMember(isa_names()));
    command.add_option("--json", arguments->json, "Write the figures to a file, too")->type_name("FILE.json");
    command.callback([arguments, &chosen] { chosen = [arguments] { return run_bench(*arguments); }; });
}

}  // namespace sluice
