// What a scene and its effects cost. How long things take is for benchmarks to say; here: every effect is accounted
// for, in its place, what is made of times is right, and what goes wrong is told.
#include "engine/run/profile/cost.hpp"

#include <omp.h>

#include <cmath>

#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"
#include "tests/engine/test_scenes.hpp"

namespace sluice::test_cost {
namespace {

/// A tenth of the usual time, however long that takes.
constexpr CostEffort little{0.1, 1e9};

const std::string water = water_box("0.0, 0.0", "0.06, 0.06"), block = rubber_box("0.0, 0.0", "0.06, 0.06");

const EffectCost& cost_of(const SceneCost& cost, Effect effect) {
    for (const EffectCost& e : cost.effects)
        if (e.choice.info.effect == effect) return e;
    throw std::logic_error("an effect is missing");
}

std::vector<CostBasis> expected_bases(Decision::Verdict verdict) {
    switch (verdict) {
        case Decision::Verdict::impossible:
            return {CostBasis::impossible};
        case Decision::Verdict::required:
            return {CostBasis::phases, CostBasis::shared};
        case Decision::Verdict::unused:
        case Decision::Verdict::used:
            return {CostBasis::switched};
    }
    return {};
}

/// All effects, as they stand in the table, each with the basis that its rule allows.
void require_complete(const Scene& scene, const SceneCost& cost) {
    const Effects effects(scene);
    REQUIRE(cost.effects.size() == effect_count);
    for (const EffectInfo& info : effect_table) {
        const EffectCost& e = cost.effects[static_cast<std::size_t>(info.effect)];
        INFO(info.key);
        REQUIRE(e.choice.info.effect == info.effect);
        REQUIRE(e.choice.on == effects.has(info.effect));
        REQUIRE_FALSE(e.choice.why.empty());
        const auto bases = expected_bases(effects[info.effect].decision.verdict);
        REQUIRE(std::count(bases.begin(), bases.end(), e.basis) == 1);
        const bool switched = e.basis == CostBasis::switched;
        REQUIRE((e.rounds >= 3) == switched);
        REQUIRE(e.uncertainty.has_value() == switched);
        REQUIRE((e.basis == CostBasis::phases ? e.share > 0 : e.share == (switched && e.choice.on ? -e.change : 0)));
        REQUIRE(std::isfinite(e.change));
    }
    REQUIRE(cost.steps > 0);
    REQUIRE(cost.cpu_per_step > 0);
    REQUIRE(cost.cpu_per_second > 0);
    REQUIRE(cost.wall_per_second > 0);
    REQUIRE(cost.rate > 0);
}

}  // namespace

TEST_CASE("Every effect of a scene of water is accounted for") {
    const Scene scene = scene_text::load(preamble(0.001) + water);
    const SceneCost cost = measure_cost<2>(scene, little);
    require_complete(scene, cost);
    REQUIRE(cost_of(cost, Effect::fluid_pressure).basis == CostBasis::phases);
    REQUIRE(cost_of(cost, Effect::velocity_filter).basis == CostBasis::switched);
    REQUIRE(cost_of(cost, Effect::solid_stress).basis == CostBasis::impossible);
    // What runs takes time, the rest none.
    const auto share = [&](StepPhase phase) { return cost.phases[static_cast<std::size_t>(phase)]; };
    for (const StepPhase phase : {StepPhase::search, StepPhase::fluid_pass, StepPhase::filter_pass, StepPhase::update})
        REQUIRE(share(phase) > 0);
    for (const StepPhase phase : {StepPhase::shift_pass, StepPhase::solid_pass, StepPhase::gradient_pass,
                                  StepPhase::contact_pass, StepPhase::interface_pass, StepPhase::wall_pass})
        REQUIRE(share(phase) == 0);
}

TEST_CASE("Every effect of a scene of solids is accounted for") {
    const std::string model = GENERATE("hypoelastic", "neo-hookean");
    const Scene scene = scene_text::load(preamble(0.002) + block, {"materials.rubber.model=" + model});
    const SceneCost cost = measure_cost<2>(scene, little);
    require_complete(scene, cost);
    const Effect stress = model == "hypoelastic" ? Effect::solid_stress : Effect::total_lagrangian;
    REQUIRE(cost_of(cost, stress).basis == CostBasis::phases);
    REQUIRE(cost_of(cost, Effect::fluid_pressure).basis == CostBasis::impossible);
}

TEST_CASE("Every effect of a scene of water and solids is accounted for") {
    const std::string preset = GENERATE("paper", "modern");
    const Scene scene = load_scene(test_scene("small_gate.toml"), {"method.preset=" + preset});
    const SceneCost cost = measure_cost<2>(scene, little);
    require_complete(scene, cost);
    const Effect coupling = preset == "paper" ? Effect::interface_force : Effect::moving_boundary;
    REQUIRE(cost_of(cost, coupling).basis == CostBasis::phases);
    REQUIRE(cost_of(cost, Effect::clamp).basis == CostBasis::shared);
}

TEST_CASE("Every effect of a scene in 3D is accounted for") {
    const Scene scene = load_scene(test_scene("still_water_3d.toml"));
    require_complete(scene, measure_cost<3>(scene, little));
}

TEST_CASE("What changes the time step is counted per simulated second") {
    // Without sub-steps all take the solid's step, a sixteenth of the water's: c0 = 20 m/s against sqrt(E/(0.6 rho)).
    const Scene scene = load_scene(test_scene("small_gate.toml"),
                                   {"method.time_stepping=multi-rate", "materials.rubber.youngs_modulus=6.4e7"});
    const EffectCost substeps = cost_of(measure_cost<2>(scene, little), Effect::solid_substeps);
    const double ratio = 20 / std::sqrt(6.4e7 / 0.6 / 1100);
    REQUIRE(substeps.step_ratio == Approx(ratio).epsilon(1e-9));  // of times that are sums of steps
}

TEST_CASE("What is switched is judged by the median of CPU times per simulated second") {
    // With the effect a turn of 10 steps of 2 ms and 3 particles costs 5 s, without it 4 s for steps of 1 ms; the
    // second turns were interrupted.
    const std::vector<CostTurn> with{{5, 5, 0.02, 10, 30}, {50, 60, 0.02, 10, 30}, {5, 5, 0.02, 10, 30}},
        without{{4, 4, 0.01, 10, 30}, {4, 4, 0.01, 10, 30}, {4, 4, 0.01, 10, 30}};
    const double per_second_with = 5 / 0.02, per_second_without = 4 / 0.01, rate = 30 / 5.0;
    EffectCost effect;
    effect.choice.on = true;
    judge_turns(with, without, rate, effect);
    CHECK(effect.basis == CostBasis::switched);
    CHECK(effect.rounds == 3);
    CHECK(effect.change == Approx(per_second_without / per_second_with - 1));
    CHECK(effect.share == Approx(-(per_second_without / per_second_with - 1)));  // below 0: it saves
    CHECK(effect.step_ratio == Approx(0.5));
    CHECK(effect.rate_change == Approx(30 / 4.0 - rate));
    CHECK(*effect.uncertainty == 0);  // of 0.16, 1.6 and 1.6
    // An effect that is off takes nothing; switched on it costs.
    effect.choice.on = false;
    judge_turns(without, with, 30 / 4.0, effect);
    CHECK(effect.share == 0);
    CHECK(effect.change == Approx(per_second_with / per_second_without - 1));
    CHECK(effect.step_ratio == Approx(2));
    CHECK(effect.rate_change == Approx(30 / 5.0 - 30 / 4.0));
    // Ratios of 1, 1.1 and 1.3: t √(π/2)/√3 · 1.4826 · 0.1, where Student's t of three values is 3 % too small.
    const std::vector<CostTurn> ones(3, {1, 1, 1, 1, 1}), others{{1, 1, 1, 1, 1}, {1.1, 1, 1, 1, 1}, {1.3, 1, 1, 1, 1}};
    judge_turns(ones, others, 1, effect);
    CHECK(effect.change == Approx(0.1));
    CHECK(*effect.uncertainty == Approx(4.303 * std::sqrt(M_PI / 2 / 3) * 1.4826 * 0.1).epsilon(0.035));
    judge_turns({ones.data(), 2}, {others.data(), 2}, 1, effect);
    CHECK(effect.change == Approx(0.05));
    CHECK_FALSE(effect.uncertainty.has_value());
}

TEST_CASE("Memory of an effect is that of its fields") {
    REQUIRE(field_bytes<2>(info_of(Effect::gravity)).empty());
    const auto plane = field_bytes<2>(info_of(Effect::velocity_filter));
    const auto space = field_bytes<3>(info_of(Effect::velocity_filter));
    REQUIRE(plane.size() == 1);
    REQUIRE(plane[0].phase == "fluid");
    REQUIRE(plane[0].bytes == 2 * sizeof(double));
    REQUIRE(space[0].bytes == 3 * sizeof(double));
    // A symmetric tensor.
    REQUIRE(field_bytes<3>(info_of(Effect::artificial_stress))[0].bytes == 6 * sizeof(double));
}

TEST_CASE("An effect that the scene will not let go is told with the scene's own words") {
    const Scene scene = scene_text::load(preamble(0.002) + water,
                                         {"method.fluid.density_diffusion=antuono", "effects.density_gradient=\"on\""});
    const EffectCost diffusion = cost_of(measure_cost<2>(scene, little), Effect::density_diffusion);
    REQUIRE(diffusion.basis == CostBasis::failed);
    REQUIRE(diffusion.note.find("effects.density_gradient") != std::string::npos);
}

TEST_CASE("Past its limit of time the measuring stops and says so") {
    const Scene scene = scene_text::load(preamble(0.002) + water);
    const SceneCost cost = measure_cost<2>(scene, {0, 0});
    REQUIRE(cost.cpu_per_step > 0);
    REQUIRE(cost_of(cost, Effect::velocity_filter).basis == CostBasis::failed);
    REQUIRE(cost_of(cost, Effect::velocity_filter).note.find("time") != std::string::npos);
}

TEST_CASE("Measuring leaves the number of threads as it was") {
    const int before = omp_get_max_threads();
    omp_set_num_threads(3);
    const SceneCost cost = measure_cost<2>(scene_text::load(preamble(0.002) + water), {0, 0});
    REQUIRE(cost.threads == 3);
    REQUIRE(omp_get_max_threads() == 3);
    omp_set_num_threads(before);
}

}  // namespace sluice::test_cost
