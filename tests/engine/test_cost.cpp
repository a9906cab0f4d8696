// What a scene and its effects cost. How long things take is for benchmarks to say; here: every effect is accounted
// for, in its place, and what goes wrong is told.
#include "engine/profile/cost.hpp"

#include <omp.h>

#include <cmath>

#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"
#include "tests/engine/test_scenes.hpp"

namespace sluice {
namespace {

/// A tenth of the usual time.
constexpr CostEffort little{0.1, 10};

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
        REQUIRE((e.rounds > 0) == (e.basis == CostBasis::switched));
        REQUIRE(std::isfinite(e.change));
        REQUIRE(e.change > -1);  // no scene costs less than nothing
    }
    REQUIRE(cost.steps > 0);
    REQUIRE(cost.cpu_per_step > 0);
    REQUIRE(cost.cpu_per_second > 0);
    REQUIRE(cost.wall_per_second > 0);
    REQUIRE(cost.rate > 0);
    double phases = 0;
    for (const double share : cost.phases) phases += share;
    REQUIRE(phases == Approx(1).epsilon(1e-12));  // rounding of their sum
}

}  // namespace

TEST_CASE("Every effect of a scene of water is accounted for") {
    const Scene scene = scene_text::load(preamble(0.001) + water);
    const SceneCost cost = measure_cost<2>(scene, little);
    require_complete(scene, cost);
    REQUIRE(cost_of(cost, Effect::fluid_pressure).basis == CostBasis::phases);
    REQUIRE(cost_of(cost, Effect::fluid_pressure).share > 0);
    // A pass over all pairs, one of three: it cannot come out free.
    REQUIRE(cost_of(cost, Effect::velocity_filter).basis == CostBasis::switched);
    REQUIRE(cost_of(cost, Effect::velocity_filter).share > 0);
    REQUIRE(cost_of(cost, Effect::velocity_filter).rate_change > 0);
    REQUIRE(cost_of(cost, Effect::solid_stress).basis == CostBasis::impossible);
    REQUIRE(cost_of(cost, Effect::solid_stress).share == 0);
}

TEST_CASE("Every effect of a scene of solids is accounted for") {
    const std::string model = GENERATE("hypoelastic", "neo-hookean");
    const Scene scene = scene_text::load(preamble(0.002) + block, {"materials.rubber.model=" + model});
    const SceneCost cost = measure_cost<2>(scene, little);
    require_complete(scene, cost);
    const Effect stress = model == "hypoelastic" ? Effect::solid_stress : Effect::total_lagrangian;
    REQUIRE(cost_of(cost, stress).share > 0);
    REQUIRE(cost_of(cost, Effect::fluid_pressure).basis == CostBasis::impossible);
}

TEST_CASE("Every effect of a scene of water and solids is accounted for") {
    const std::string preset = GENERATE("paper", "modern");
    const Scene scene = load_scene(test_scene("small_gate.toml"), {"method.preset=" + preset});
    const SceneCost cost = measure_cost<2>(scene, little);
    require_complete(scene, cost);
    const Effect coupling = preset == "paper" ? Effect::interface_force : Effect::moving_boundary;
    REQUIRE(cost_of(cost, coupling).share > 0);
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
    REQUIRE(substeps.change > 0);
    REQUIRE(substeps.share < 0);  // it saves
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

}  // namespace sluice
