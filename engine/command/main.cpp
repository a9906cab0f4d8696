// The command `sluice`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

#include "engine/base/version.hpp"
#include "engine/command/commands.hpp"
#include "engine/scene/table/suggestion.hpp"

namespace {

constexpr const char* examples = R"(Examples:
  sluice new dam-break
  sluice check dam-break.toml --draw
  sluice check validation/elastic_gate/scene.toml
  sluice run validation/elastic_gate/scene.toml
  sluice run dam.toml -o results/fine --set method.spacing=0.001 --threads 2
  sluice help scene method.spacing
  sluice help effects particle_shifting
  sluice run dam.toml --until 0.1
  sluice run --resume results/dam
  sluice run dam.toml --until 0.1 --profile
  sluice bench dam.toml
  sluice study dam.toml --vary method.spacing=x2,x1,x0.5 --vary method.precision=mixed,double
  sluice check dam.toml --target-error 3%
  sluice view results/dam
  sluice view results/dam --serve
  sluice render results/dam --field pressure

A run writes into its folder: scene.toml (what was run), probes.csv, summary.json, and frames/, of which
ParaView opens frames.hdf.series. Every ten minutes, and when it is stopped by Ctrl-C or `kill`, it writes
a checkpoint into checkpoints/; with --resume it goes on from there, to the same results as if it had never
been stopped. A study writes study.html, study.svg, study.csv and study.json.

Exit codes: 0 done, 1 numerical failure, 2 bad input, 3 output failed, 130 interrupted.)";

/// What is wrong with the command line; of a command that is not there, which one may be meant.
std::string explain(const CLI::App& program, const CLI::ParseError& error, const std::string& first) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    if (first.empty() || first[0] == '-' || std::find(names.begin(), names.end(), first) != names.end())
        return error.what();
    return fmt::format("found \"{}\", expected {}{}", first, sluice::one_of(names), sluice::did_you_mean(first, names));
}

}  // namespace

int main(int argc, char** argv) {
    // A file beyond the shell's size limit is then an ordinary write error with a message, not a silent death.
    std::signal(SIGXFSZ, SIG_IGN);
    CLI::App program("Water against elastic structures by smoothed particle hydrodynamics.", "sluice");
    program.set_version_flag("--version", std::string("sluice ") + std::string(sluice::program_version()));
    program.require_subcommand(1);
    program.footer(examples);
    sluice::Deed chosen;
    sluice::add_new_command(program, chosen);
    sluice::add_run_command(program, chosen);
    sluice::add_check_command(program, chosen);
    sluice::add_bench_command(program, chosen);
    sluice::add_study_command(program, chosen);
    sluice::add_view_command(program, chosen);
    sluice::add_render_command(program, chosen);
    sluice::add_help_command(program, chosen);
    sluice::add_completion_command(program, chosen);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return program.exit(error);
        sluice::print_error(explain(program, error, argc > 1 ? argv[1] : "") +
                            "\n`sluice --help` shows how it is used");
        return static_cast<int>(sluice::ExitCode::bad_input);
    }
    return static_cast<int>(sluice::guarded(chosen));
}
