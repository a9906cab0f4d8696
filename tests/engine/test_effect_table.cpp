// The table of effects and their rules: every row can be on and off, and its columns are those that there are.
#include "engine/scene/rules/effects.hpp"

#include <algorithm>
#include <set>

#include "engine/particles/particle_set.hpp"
#include "tests/catch.hpp"
#include "tests/engine/effect_scenes.hpp"

namespace sluice::test_effect_table {
TEST_CASE("Each of the table's rows has every entry, and a name of its own") {
    std::set<std::string_view> names;
    for (const EffectInfo& effect : effect_table) {
        CAPTURE(std::string(effect.key));
        REQUIRE_FALSE(effect.name.empty());
        REQUIRE_FALSE(effect.equation.empty());
        REQUIRE(effect.automatic.starts_with("on if "));
        REQUIRE_FALSE(effect.formula.empty());
        REQUIRE(effect.formula.find('\n') == std::string_view::npos);
        REQUIRE(find_effect(effect.key) == &effect);
        REQUIRE(names.insert(effect.name).second);
    }
    REQUIRE_FALSE(find_effect("no_such_effect"));
}

TEST_CASE("Every column is needed by some effect") {
    for (const ColumnInfo& info : column_table) {
        CAPTURE(std::string(info.name));
        CHECK(std::ranges::any_of(effect_table, [&](const EffectInfo& effect) {
            return std::ranges::any_of(all_sets, [&](SetId set) { return effect.columns.has(set, info.column); });
        }));
    }
}

TEST_CASE("Every effect is on in a scene that calls for it and off in one that does not; both scenes run") {
    const std::vector<effect_scenes::Case> cases = effect_scenes::cases();
    std::set<Effect> seen;
    for (const auto& c : cases) {
        seen.insert(c.effect);
        for (const bool wanted : {true, false}) {
            Simulation<2> simulation((wanted ? c.on : c.off).load());
            const EffectChoice& choice = simulation.effects()[c.effect];
            CAPTURE(std::string(choice.info.key), wanted, choice.why);
            REQUIRE(choice.info.effect == c.effect);
            REQUIRE(choice.on == wanted);
            REQUIRE_FALSE(choice.why.empty());
            // What the table says of the rule in words.
            const bool is_required = choice.info.automatic.find("cannot be left out") != std::string_view::npos;
            if (wanted) REQUIRE((choice.decision.verdict == Decision::Verdict::required) == is_required);
            advance(simulation, 2);
            REQUIRE(std::isfinite(simulation.energy().total()));
        }
    }
    REQUIRE(seen.size() == effect_count);
}

TEST_CASE("A rule follows what was decided of the effect that it builds on") {
    const auto effects = [](const std::string& content, const std::vector<std::string>& overrides) {
        return Effects(scene_text::load(effect_scenes::scene(content), overrides));
    };
    using namespace effect_scenes;
    const std::string both = water + block, wall_alone = block + moving;
    const std::vector<std::string> fourtakas{"method.fluid.density_diffusion=fourtakas", "gravity=[0.0, -9.81]"},
        antuono{"method.fluid.density_diffusion=antuono"},
        at_own_rate{"method.time_stepping=multi-rate", total_lagrangian};
    const auto with = [](std::vector<std::string> overrides, const std::string& more) {
        overrides.push_back(more);
        return overrides;
    };
    struct Pair {
        Effect effect;
        const std::string& content;
        std::vector<std::string> on;
        std::string changed, why;
    };
    const std::vector<Pair> pairs{
        {Effect::excess_density, water, fourtakas, "effects.density_diffusion=off",
         "no density diffusion by Fourtakas et al."},
        {Effect::density_gradient, water, antuono, "effects.density_diffusion=off",
         "no density diffusion by Antuono et al."},
        {Effect::steady_load, both, at_own_rate, "effects.solid_substeps=off", "the solid has no steps of its own"},
        {Effect::moving_wall, wall_alone, {total_lagrangian}, "effects.contact=off", "no fluid body to move"},
        {Effect::no_slip_solid,
         both,
         {"method.coupling=moving-boundary", viscous},
         "method.coupling=interface-force",
         "method.coupling is another"},
    };
    for (const Pair& p : pairs) {
        CAPTURE(std::string(info_of(p.effect).key));
        CHECK(effects(p.content, p.on).has(p.effect));
        const Effects without = effects(p.content, with(p.on, p.changed));
        CHECK_FALSE(without.has(p.effect));
        CHECK(without[p.effect].why == p.why);
    }
    // Steps of its own are the solid's whether the method calls for them or [effects] does.
    CHECK(effects(both, {"method.time_stepping=single-rate", "effects.solid_substeps=on", total_lagrangian})
              .has(Effect::steady_load));
    // Hypoelastic solids meet walls only if that is asked for.
    CHECK_FALSE(effects(wall_alone, {}).has(Effect::moving_wall));
    CHECK(effects(wall_alone, {"effects.contact=on"}).has(Effect::moving_wall));
}

TEST_CASE("The table's rules hold in three dimensions") {
    const std::string box = R"toml(
[bodies.block]
material = "rubber"
shape = { box = { min = [0.0, 0.0, 0.0], max = [0.01, 0.01, 0.01] } }
[bodies.water]
material = "water"
shape = { box = { min = [0.01, 0.0, 0.0], max = [0.02, 0.01, 0.01] } }
)toml";
    const Scene scene =
        scene_text::load("dimension = 3\n" + preamble(0.002) + box, {"method.preset=modern", "method.spacing=0.0025"});
    Simulation<3> simulation(scene);
    for (const Effect e : {Effect::moving_boundary, Effect::total_lagrangian, Effect::particle_shifting})
        REQUIRE(simulation.effects().has(e));
    REQUIRE(simulation.boundary().owned > 0);
    simulation.step();
    REQUIRE(std::isfinite(simulation.energy().total()));
}

}  // namespace sluice::test_effect_table
