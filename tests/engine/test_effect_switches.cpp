// [effects]: what may be switched, what is refused and with which reason, and where the choice is told.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/run/summary.hpp"
#include "engine/scene/rules/effects.hpp"
#include "tests/catch.hpp"
#include "tests/engine/effect_scenes.hpp"

namespace sluice::test_effect_switches {
namespace {

using Verdict = Decision::Verdict;

/// The scene of one side with a switch at its end, and the switch's line.
struct Switched {
    std::string text, path;
    std::vector<std::string> overrides;
    long line;

    Switched(const effect_scenes::Case::Side& side, const std::string& key, const std::string& value)
        : text(effect_scenes::scene(side.content) + "[effects]\n" + key + " = \"" + value + "\"\n"),
          path("effects." + key),
          overrides(side.overrides),
          line(std::count(text.begin(), text.end(), '\n')) {}
    bool is_on(Effect e) const { return Effects(scene_text::load(text, overrides)).has(e); }
    std::string error() const {
        return scene_text::error_of([&] { Effects{scene_text::load(text, overrides)}; });
    }
    std::string place() const { return std::to_string(line) + ": " + path + ": "; }
};

Decision decide(const effect_scenes::Case::Side& side, Effect e) { return Effects(side.load())[e].decision; }

}  // namespace

TEST_CASE("\"off\" turns off what a scene can do without, and is refused with the reason where it cannot") {
    for (const auto& c : effect_scenes::cases()) {
        const std::string key(info_of(c.effect).key);
        const Decision d = decide(c.on, c.effect);
        const Switched off(c.on, key, "off");
        CAPTURE(key, d.why);
        if (d.verdict == Verdict::required) {
            CHECK(off.error() == off.place() + "found \"off\", but the scene cannot do without: " + d.why +
                                     "; expected \"auto\" or \"on\"");
        } else {
            CHECK(off.error().empty());
            CHECK_FALSE(off.is_on(c.effect));
            Simulation<2> simulation(scene_text::load(off.text, off.overrides));
            advance(simulation, 2);
            CHECK(std::isfinite(simulation.energy().total()));
        }
        CHECK(Switched(c.on, key, "auto").is_on(c.effect));
        CHECK(Switched(c.on, key, "on").is_on(c.effect));
    }
}

TEST_CASE("\"on\" turns on what a scene leaves unused, and is refused with the reason where it cannot act") {
    for (const auto& c : effect_scenes::cases()) {
        const std::string key(info_of(c.effect).key);
        const Decision d = decide(c.off, c.effect);
        const Switched on(c.off, key, "on");
        CAPTURE(key, d.why);
        if (d.verdict == Verdict::impossible)
            CHECK(on.error() == on.place() + "found \"on\", but there is nothing for it to act on: " + d.why +
                                    "; expected \"auto\" or \"off\"");
        else
            CHECK(on.is_on(c.effect));
        CHECK(Switched(c.off, key, "off").error().empty());
        CHECK_FALSE(Switched(c.off, key, "auto").is_on(c.effect));
    }
}

TEST_CASE("What is switched off does nothing, as if its constant were that without it") {
    struct Pair {
        const char *key, *constant, *base, *content;
    };
    const std::string moving_water = effect_scenes::water + "velocity = [\"sin(200*y)\", \"0\"]\n";
    const std::string moving_block = effect_scenes::block + "velocity = [\"sin(200*y)\", \"40*x\"]\n";
    const std::vector<Pair> pairs{
        {"artificial_viscosity", "method.fluid.artificial_viscosity=0", "method.fluid.artificial_viscosity=0.3", "w"},
        {"laminar_viscosity", "materials.water.viscosity=0.0", "materials.water.viscosity=0.5", "w"},
        {"acoustic_damping", "method.fluid.acoustic_damping=0", "method.fluid.acoustic_damping=0.5", "w"},
        {"density_diffusion", "method.fluid.density_diffusion=none", "method.fluid.density_diffusion=antuono", "w"},
        {"velocity_filter", "method.fluid.velocity_filter=1", "method.fluid.velocity_filter=0.92", "w"},
        {"particle_shifting", "method.fluid.particle_shifting=0", "method.fluid.particle_shifting=2", "w"},
        {"gravity", "gravity=[0.0, 0.0]", "gravity=[0.0, -9.81]", "w"},
        {"driven_acceleration", "acceleration=[0.0, 0.0]", "acceleration=[9.0, 't']", "w"},
        {"adaptive_step", "method.step_size=fixed", "method.step_size=adaptive", "w"},
        {"solid_viscosity", "method.solid.artificial_viscosity=0", "method.solid.artificial_viscosity=1", "b"},
        {"artificial_stress", "method.solid.artificial_stress=0", "method.solid.artificial_stress=0.3", "b"},
        {"solid_filter", "method.solid.velocity_filter=1", "method.solid.velocity_filter=0.9", "b"},
        {"hourglass_control", "method.solid.hourglass_control=0", "method.solid.hourglass_control=0.1", "t"},
        {"solid_viscosity", "method.solid.artificial_viscosity=0", "method.solid.artificial_viscosity=1", "t"},
    };
    for (const Pair& p : pairs) {
        CAPTURE(p.key, p.content);
        const bool of_water = p.content[0] == 'w';
        const std::string text = effect_scenes::scene(of_water ? moving_water : moving_block);
        std::vector<std::string> common;
        if (p.content[0] == 't') common.push_back(effect_scenes::total_lagrangian);
        const auto run = [&](const std::vector<std::string>& more) {
            std::vector<std::string> overrides = common;
            overrides.insert(overrides.end(), more.begin(), more.end());
            Simulation<2> s(scene_text::load(text, overrides));
            advance(s, 20);
            return std::pair{s.fluid().position.c, s.solid().position.c};
        };
        const auto on = run({p.base}), off = run({p.base, "effects." + std::string(p.key) + "=off"});
        CHECK(off == run({p.constant}));
        CHECK(off != on);
    }
}

TEST_CASE("Unknown effects and words are refused with the nearest that would be right") {
    const std::string text = effect_scenes::scene(effect_scenes::water);
    const auto line = std::to_string(std::count(text.begin(), text.end(), '\n') + 2);
    const auto error = [&](const std::string& row) {
        return scene_text::load_error(text + "[effects]\n" + row + "\n");
    };
    const std::string unknown = error("velocity_fliter = \"off\"");
    CHECK(unknown.starts_with(line + ": effects.velocity_fliter: found an unknown key, expected one of "));
    CHECK(unknown.ends_with("; did you mean \"velocity_filter\"?"));
    for (const EffectInfo& info : effect_table)
        CHECK(unknown.find(fmt::format("\"{}\"", info.key)) != std::string::npos);
    CHECK(error("velocity_filter = \"offf\"").starts_with(line + ": effects.velocity_filter: "));
    CHECK(error("velocity_filter = \"offf\"").find("did you mean \"off\"?") != std::string::npos);
    CHECK(error("velocity_filter = false").starts_with(line + ": effects.velocity_filter: found false, expected"));
}

TEST_CASE("Switches on the command line are told as such") {
    const std::string text = effect_scenes::scene(effect_scenes::water);
    const std::vector<std::string> overrides{"effects.fluid_pressure=off"};
    const std::string error = scene_text::error_of([&] { Effects{scene_text::load(text, overrides)}; });
    CHECK(error.find("--set effects.fluid_pressure: found \"off\"") != std::string::npos);
}

TEST_CASE("The summary names every effect with its choice and the reason") {
    const Simulation<2> simulation(scene_text::load(effect_scenes::scene(effect_scenes::water),
                                                    {"effects.velocity_filter=off", "gravity=[0.0, -9.81]"}));
    const auto effects = nlohmann::json::parse(summary_text(simulation, RunRecord{}))["effects"];
    REQUIRE(effects.size() == effect_count);
    for (const EffectChoice& choice : simulation.effects().all()) {
        const auto& told = effects[std::string(choice.info.key)];
        CHECK(told["on"] == choice.on);
        CHECK(told["name"] == std::string(choice.info.name));
        CHECK(told["why"] == choice.why);
        CHECK(told["equation"] == std::string(choice.info.equation));
    }
    CHECK(effects["velocity_filter"]["why"] == "switched off; theta = 0.92");
    CHECK(effects["gravity"]["why"] == "g = (0, -9.81, 0) m/s2");
    CHECK(effects["fluid_pressure"]["why"] == "fluid bodies: water");
}

}  // namespace sluice::test_effect_switches
