#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/errors.hpp"
#include "engine/command/commands.hpp"
#include "engine/view/render.hpp"
#include "engine/view/video.hpp"

namespace sluice {
namespace {

struct RenderArguments {
    RenderOptions options;
    std::string output, video = "mp4", size;
    std::vector<double> range, solid_range, window, angles;
    int frames_per_second = 20;
    bool dark = false;
};

constexpr const char* render_footer =
    R"(Fields are those of the frames, and speed. Fluid and solid each have their own field, range and colours.

  sluice render results/dam                            results/dam/pictures/frame_0000.png …, movie.mp4
  sluice render results/dam --field pressure --range 0,5000 --window 0,0,1.6,0.6
  sluice render results/dam --size 1920x1080 --fps 30 --video webm -o dam_pictures
)";

/// "1280x720". Sides are made even, as video formats want them.
void use_size(const std::string& text, PictureStyle& style) {
    constexpr int most = 8192;  // four times the width of common screens; typing errors are larger
    int sides[2] = {0, 0};
    const char* end = text.data() + text.size();
    const auto [cross, bad] = std::from_chars(text.data(), end, sides[0]);
    const bool split = bad == std::errc() && cross != end && *cross == 'x';
    const bool whole = split && std::from_chars(cross + 1, end, sides[1]).ptr == end;
    if (!whole || sides[0] < 64 || sides[1] < 64 || sides[0] > most || sides[1] > most)
        throw RunReadError(
            fmt::format("--size: found \"{}\", expected two sides from 64 to {}, as 1280x720", text, most));
    style.width = sides[0] / 2 * 2;
    style.height = sides[1] / 2 * 2;
}

std::optional<std::pair<double, double>> range_of(const std::vector<double>& values, const char* option) {
    if (values.empty()) return std::nullopt;
    if (values.size() != 2 || !(values[0] < values[1]))
        throw RunReadError(fmt::format("{}: expected LOW,HIGH with LOW < HIGH", option));
    return std::pair(values[0], values[1]);
}

void use_window(const std::vector<double>& w, PictureStyle& style) {
    if (w.empty()) return;
    if (w.size() != 4 || !(w[0] < w[2]) || !(w[1] < w[3]))
        throw RunReadError("--window: expected X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1");
    style.window = {{{w[0], w[2]}, {w[1], w[3]}}};
}

void make_video(const RenderArguments& arguments) {
    const std::optional<VideoKind> kind = video_kind_of(arguments.video);
    if (!kind) return;
    const auto ffmpeg = find_ffmpeg();
    if (!ffmpeg)
        throw OutputError(
            "no video: ffmpeg is not installed; `sudo apt install ffmpeg` installs it, --video none does without");
    const std::filesystem::path video =
        write_video(*ffmpeg, arguments.options.output, *kind, arguments.frames_per_second);
    print(fmt::format("video in {}\n", video.string()));
}

ExitCode render(RenderArguments arguments) {
    RenderOptions& options = arguments.options;
    use_size(arguments.size, options.style);
    use_window(arguments.window, options.style);
    options.fluid.range = range_of(arguments.range, "--range");
    options.solid.range = range_of(arguments.solid_range, "--solid-range");
    if (arguments.angles.size() == 2) options.style.angles = {arguments.angles[0], arguments.angles[1]};
    if (arguments.dark) options.style.theme = Theme::dark;
    options.output =
        arguments.output.empty() ? options.directory / "pictures" : std::filesystem::path(arguments.output);
    const RenderResult result = render_run(options);
    for (const std::string& problem : result.left_out) print_warning(problem + "; left out");
    print(fmt::format("{} pictures in {}\n", result.frames, options.output.string()));
    make_video(arguments);
    return ExitCode::done;
}

void add_color_options(CLI::App& command, RenderArguments& arguments) {
    RenderOptions& options = arguments.options;
    command.add_option("--field", options.fluid.field, "What colours the fluid; none = one colour [speed]")
        ->type_name("NAME");
    command.add_option("--range", arguments.range, "Ends of its colours, in SI units [as nearly all values lie]")
        ->type_name("LOW,HIGH")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--map", options.fluid.map, "Its colours: viridis, cividis, plasma, coolwarm")
        ->type_name("NAME");
    command.add_option("--solid-field", options.solid.field, "What colours the solids; none = one colour [von_mises]")
        ->type_name("NAME");
    command.add_option("--solid-range", arguments.solid_range, "Ends of their colours")
        ->type_name("LOW,HIGH")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--solid-map", options.solid.map, "Their colours")->type_name("NAME");
    command.add_flag("--dark", arguments.dark, "Light on dark");
}

}  // namespace

void add_render_command(CLI::App& program, Deed& chosen) {
    CLI::App& command = *program.add_subcommand("render", "Draw a run's frames as pictures, and make a video of them");
    const auto arguments = std::make_shared<RenderArguments>();
    RenderOptions& options = arguments->options;
    arguments->size = "1280x720";
    command.add_option("DIR", options.directory, "Folder of a run")->required();
    command.add_option("-o,--output", arguments->output, "Folder for the pictures [DIR/pictures]")->type_name("DIR");
    add_color_options(command, *arguments);
    command.add_option("--size", arguments->size, "Width and height in pixels [1280x720]")->type_name("WxH");
    command.add_option("--window", arguments->window, "2D: the part that is shown, in metres [all]")
        ->type_name("X0,Y0,X1,Y1")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        .add_option("--angles", arguments->angles, "3D: turned about the vertical and looked down, in degrees [30,20]")
        ->type_name("TURN,DOWN")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--every", options.every, "Draw every N-th frame [1]")
        ->type_name("N")
        ->check(CLI::PositiveNumber);
    constexpr int most_per_second = 240;
    command.add_option("--fps", arguments->frames_per_second, "Frames per second of the video [20]")
        ->type_name("N")
        ->check(CLI::Range(1, most_per_second));
    command.add_option("--video", arguments->video, "mp4, webm, or none: pictures alone [mp4]")
        ->check(CLI::IsMember({"mp4", "webm", "none"}));
    command.footer(render_footer);
    command.callback([arguments, &chosen] { chosen = [arguments] { return render(*arguments); }; });
}

}  // namespace sluice
