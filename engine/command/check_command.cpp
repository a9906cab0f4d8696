#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>

#include "engine/base/number_text.hpp"
#include "engine/base/text_hash.hpp"
#include "engine/command/commands.hpp"
#include "engine/command/cost_table.hpp"
#include "engine/command/scene_options.hpp"
#include "engine/command/study_text.hpp"
#include "engine/command/thread_settings.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/run/output/probes.hpp"
#include "engine/scene/check/suspicion.hpp"
#include "engine/study/stored_study.hpp"
#include "engine/view/scene_picture.hpp"
#include "neighbor/isa.hpp"

namespace sluice {
namespace {

std::string row(std::string_view name, const std::string& value) { return fmt::format("{:<22}{}\n", name, value); }

std::size_t particles_of(const Array<std::uint16_t>& body, std::size_t owned, std::size_t wanted) {
    return static_cast<std::size_t>(
        std::count(body.begin(), body.begin() + static_cast<std::ptrdiff_t>(owned), wanted));
}

template <int Dim>
std::string particle_table(const Simulation<Dim>& simulation) {
    const Scene& scene = simulation.scene();
    const auto& fluid = simulation.fluid();
    const auto& solid = simulation.solid();
    const auto& wall = simulation.wall();
    std::string text = fmt::format("{:<22}{:<8}{:>10}{:>16}\n", "body", "medium", "particles", "spacing");
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const Body& body = scene.bodies[b];
        const bool is_fluid = scene.materials[body.material].kind == MaterialKind::fluid;
        const std::size_t count =
            is_fluid ? particles_of(fluid.body, fluid.owned, b) : particles_of(solid.body, solid.owned, b);
        text +=
            fmt::format("{:<22}{:<8}{:>10}{:>14.4g} m\n", body.name, is_fluid ? "fluid" : "solid", count, body.spacing);
    }
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
        if (scene.walls[w].kind == WallKind::fixed)
            text += fmt::format("{:<22}{:<8}{:>10}{:>14.4g} m\n", scene.walls[w].name, "wall",
                                particles_of(wall.body, wall.owned, w), scene.walls[w].spacing);
    return text;
}

/// The time step, and what each medium would allow.
template <int Dim>
std::string step_table(const Simulation<Dim>& simulation) {
    const double dt = simulation.time_step();
    const double steps = std::round(simulation.scene().output.end / dt);  // a run ends at the step nearest to its end
    std::string text = row(
        "time step", fmt::format("{:.6g} s{}", dt, simulation.scene().method.time_step ? ", as the scene states" : ""));
    const auto& limits = simulation.courant_limits();
    const auto limiting =
        std::min_element(limits.begin(), limits.end(), [](const auto& a, const auto& b) { return a.dt < b.dt; });
    for (auto limit = limits.begin(); limit != limits.end(); ++limit)
        text += row("  limit of " + limit->medium,
                    fmt::format("{:.6g} s{}", limit->dt, limit == limiting ? ", the smallest" : ""));
    if (simulation.solid_substeps() > 1)
        text += row("solid sub-steps", fmt::format("{} of {:.6g} s in each step", simulation.solid_substeps(),
                                                   dt / simulation.solid_substeps()));
    text += row("expected steps", fmt::format("{:.0f} to {:.6g} s", steps, simulation.scene().output.end));
    return text;
}

std::string effects_text(const Effects& effects) {
    std::size_t key = 0, name = 0, equation = 0;
    for (const EffectChoice& choice : effects.all()) {
        key = std::max(key, choice.info.key.size());
        name = std::max(name, choice.info.name.size());
        equation = std::max(equation, choice.info.equation.size());
    }
    constexpr const char* layout = "{:<{}}  {:<3}  {:<{}}  {:<{}}  {}\n";
    std::string text = fmt::format(layout, "effect", name, "", "key", key, "equation", equation, "why");
    for (const EffectChoice& choice : effects.all())
        text += fmt::format(layout, choice.info.name, name, choice.on ? "on" : "off", choice.info.key, key,
                            choice.info.equation, equation, choice.why);
    return text + "\n`sluice help effects KEY` explains each of them\n";
}

struct CheckArguments {
    SceneOptions scene;
    bool cost = false;
    int threads = 0;
    std::optional<std::string> draw;  ///< file of a picture; empty = named after the scene
    std::string target_error;
    std::string study;
};

/// 3% or 0.03.
double share_of(const std::string& text) {
    std::size_t end = 0;
    const double value = std::stod(text, &end);
    return text.substr(end) == "%" ? value / 100 : value;
}

std::string share_problem(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool is_share = end != text.c_str() && value > 0 && (*end == '\0' || std::string(end) == "%");
    return is_share ? "" : fmt::format("found \"{}\", expected a share > 0, like 3% or 0.03", text);
}

template <int Dim>
std::string scene_text(const Scene& scene) {
    const Simulation<Dim> simulation(scene);
    const Probes<Dim> probes(simulation);
    std::string text = fmt::format("{}: {}\n\n", scene.file, scene.title);
    text += particle_table(simulation) + "\n" + step_table(simulation);
    text += row("memory", memory_text(static_cast<double>(simulation.memory_bytes())));
    text += row("precision", std::string(word_of(scene.method.precision)));
    text += row("instruction set", std::string(name_of(active_isa())));
    text += row("scene hash", text_hash(scene.source));
    const std::vector<std::string> columns = probes.columns();
    text += row("probe columns", columns.empty() ? "none" : fmt::format("{}", fmt::join(columns, ", ")));
    text += reference_table(scene);
    return text + "\n" + effects_text(simulation.effects());
}

template <int Dim>
ExitCode check_scene(const Scene& scene, const CheckArguments& arguments) {
    print(scene_text<Dim>(scene));
    if (arguments.cost) print("\n" + cost_text(measure_cost<Dim>(scene), scene.output.end));
    return ExitCode::done;
}

/// Drawn before the scene is checked in space, as it shows what is wrong there.
void draw_scene(const Scene& scene, const std::string& file) {
    const std::filesystem::path picture =
        file.empty() ? default_directory(scene.file).filename().string() + ".png" : file;
    if (picture.extension() != ".png")
        throw SceneError(fmt::format("--draw: found \"{}\", expected the name of a picture, as scene.png", file));
    write_atomically(picture, scene_picture(scene));
    print_note("picture in " + picture.string());
}

ExitCode tell_target(const Scene& scene, const CheckArguments& arguments) {
    const std::filesystem::path file =
        arguments.study.empty() ? study_beside(scene.file) : std::filesystem::path(arguments.study);
    print(target_report(scene, file, share_of(arguments.target_error)));
    return ExitCode::done;
}

}  // namespace

void add_check_command(CLI::App& program, Deed& chosen) {
    CLI::App& command = *program.add_subcommand("check", "Check a scene and say what a run would do");
    const auto arguments = std::make_shared<CheckArguments>();
    arguments->scene.add_to(command);
    command.add_option("--draw", arguments->draw, "Draw the particles at the start [NAME OF THE SCENE.png]")
        ->type_name("FILE.png")
        ->expected(0, 1);
    CLI::Option* cost = command.add_flag("--cost", arguments->cost,
                                         "Measure for a second or more what the scene and each of its effects cost");
    command.add_option("--threads", arguments->threads, "Number of threads of the run whose time is asked for [all]")
        ->type_name("N")
        ->check(CLI::Range(1, most_threads))
        ->needs(cost);
    CLI::Option* target =
        command
            .add_option("--target-error", arguments->target_error,
                        "Say instead which settings reach this error, and at what cost, by the study of the scene")
            ->type_name("SHARE")
            ->check(CLI::Validator(share_problem, ""));
    command.add_option("--study", arguments->study, "The study to ask [study.json beside the scene]")
        ->type_name("FILE")
        ->needs(target);
    command.callback([arguments, &chosen] {
        chosen = [arguments] {
            if (arguments->cost) use_thread_settings(arguments->threads);
            if (arguments->threads > 0) omp_set_num_threads(arguments->threads);
            const Scene scene = load_scene(arguments->scene.file, arguments->scene.overrides);
            for (const std::string& doubt : suspicious_values(scene)) print_warning(doubt);
            if (arguments->draw) draw_scene(scene, *arguments->draw);
            if (!arguments->target_error.empty()) return tell_target(scene, *arguments);
            return scene.dimension == 2 ? check_scene<2>(scene, *arguments) : check_scene<3>(scene, *arguments);
        };
    });
}

}  // namespace sluice
