#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/command/commands.hpp"
#include "engine/view/view_page.hpp"
#include "engine/view/view_server.hpp"

namespace sluice {
namespace {

struct ViewArguments {
    ViewOptions options;
    std::string output;
    std::string port;  ///< as text: CLI11 takes the 0 of a flag for "no"
};

constexpr const char* view_footer =
    R"(The page holds the run: it opens from the disk, without a network, and can be passed on.
Colours by any field, curves of the probes, particles with their values; `?` in it lists the keys.

  sluice view results/dam                        writes results/dam/view.html
  sluice view results/dam -o dam.html --every 2 --fields velocity,pressure
  sluice view results/dam --serve                shows a run while it goes on, at http://127.0.0.1:7878/
)";

constexpr double megabyte = 1e6;
/// Browsers open larger pages too, but take their time.
constexpr double large_page = 200 * megabyte;

ExitCode write_page(const ViewArguments& arguments) {
    const std::filesystem::path file =
        arguments.output.empty() ? arguments.options.directory / "view.html" : std::filesystem::path(arguments.output);
    const ViewResult result = write_view_page(arguments.options, file);
    for (const std::string& problem : result.left_out) print_warning(problem + "; left out");
    print(fmt::format("{} frames, {:.1f} MB: open {} in a browser\n", result.frames,
                      static_cast<double>(result.bytes) / megabyte, file.string()));
    if (static_cast<double>(result.bytes) > large_page)
        print_note(
            "a smaller page loads faster: --every 2 takes every second frame, --fields velocity,pressure only these");
    if (result.status == "running")
        print_note("the run goes on, or was cut off: the page holds the frames so far; --serve follows a run");
    return ExitCode::done;
}

ExitCode serve(const ViewArguments& arguments) {
    LiveRun run(arguments.options.directory, arguments.options.fields);
    serve_run(run, std::stoi(arguments.port), [](const std::string& address) {
        print(fmt::format("open {} in a browser; Ctrl-C ends it\n", address));
    });
    return ExitCode::done;
}

}  // namespace

void add_view_command(CLI::App& program, Deed& chosen) {
    CLI::App& command = *program.add_subcommand("view", "Write a page that shows a run, or follow a run in one");
    const auto arguments = std::make_shared<ViewArguments>();
    command.add_option("DIR", arguments->options.directory, "Folder of a run")->required();
    CLI::Option* output =
        command.add_option("-o,--output", arguments->output, "The page [DIR/view.html]")->type_name("FILE.html");
    CLI::Option* every =
        command.add_option("--every", arguments->options.every, "Take every N-th frame, and the last [1]")
            ->type_name("N")
            ->check(CLI::PositiveNumber);
    command
        .add_option("--fields", arguments->options.fields,
                    "Fields to take along, e.g. velocity,pressure,von_mises [all]")
        ->type_name("NAME,...")
        ->delimiter(',')
        ->allow_extra_args(false);
    constexpr int last_port = 65535;
    CLI::Option* server =
        command
            .add_flag("--serve{7878}", arguments->port,
                      "Write nothing; show the run, also one that goes on, at this port of this machine alone: "
                      "--serve or --serve=PORT, 0 = any that is free")
            ->type_name("PORT")
            ->check(CLI::Range(0, last_port))
            ->excludes(output)
            ->excludes(every);
    command.footer(view_footer);
    command.callback([arguments, server, &chosen] {
        const bool served = !server->empty();
        chosen = [arguments, served] { return served ? serve(*arguments) : write_page(*arguments); };
    });
}

}  // namespace sluice
