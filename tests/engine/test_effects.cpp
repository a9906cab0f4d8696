// Which effects a scene calls for, what is allocated for them, and the time step.
#include "engine/effects.hpp"

#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice {
namespace {

const std::string water = R"toml(
[bodies.water]
material = "water"
shape = { box = { min = [0.0, 0.0], max = [0.02, 0.02] } }
)toml";
const std::string block = R"toml(
[bodies.block]
material = "rubber"
shape = { box = { min = [0.03, 0.0], max = [0.05, 0.02] } }
)toml";

}  // namespace

TEST_CASE("A scene of water alone has no effect and no field of a solid") {
    const Simulation<2> simulation(scene_text::load(preamble(0.002) + water));
    const Effects& effects = simulation.effects();
    REQUIRE(effects.has(Effect::fluid_pressure));
    REQUIRE(effects.has(Effect::velocity_filter));
    for (const Effect e : {Effect::artificial_viscosity, Effect::solid_stress, Effect::solid_viscosity,
                           Effect::artificial_stress, Effect::interface_force, Effect::mirror_wall, Effect::fixed_wall,
                           Effect::clamp, Effect::gravity, Effect::variable_resolution})
        REQUIRE_FALSE(effects.has(e));
    REQUIRE(simulation.solid().deviatoric_stress.size() == 0);
    REQUIRE(simulation.solid().artificial_stress.size() == 0);
    REQUIRE(simulation.interface().position.size() == 0);
    REQUIRE(simulation.wall().position.size() == 0);
    for (const EffectChoice& choice : effects.all()) REQUIRE_FALSE(choice.why.empty());
}

TEST_CASE("A scene of solids alone has no effect and no field of a fluid") {
    const Simulation<2> simulation(scene_text::load(preamble(0.002) + block, {"method.solid.artificial_stress=0"}));
    REQUIRE(simulation.effects().has(Effect::solid_stress));
    REQUIRE(simulation.effects().has(Effect::solid_viscosity));
    REQUIRE_FALSE(simulation.effects().has(Effect::artificial_stress));
    REQUIRE_FALSE(simulation.effects().has(Effect::interface_force));
    REQUIRE(simulation.fluid().position.size() == 0);
    REQUIRE(simulation.fluid().velocity_correction.size() == 0);
    REQUIRE(simulation.solid().artificial_stress.size() == 0);
    REQUIRE(simulation.solid().velocity_correction.size() == 0);
    REQUIRE(simulation.interface().position.size() == 0);
}

TEST_CASE("Water and solid together have an interface; theta = 1 takes the filter out") {
    const Simulation<2> simulation(
        scene_text::load(preamble(0.002) + water + block, {"method.fluid.velocity_filter=1"}));
    REQUIRE(simulation.effects().has(Effect::interface_force));
    REQUIRE_FALSE(simulation.effects().has(Effect::velocity_filter));
    REQUIRE(simulation.fluid().velocity_correction.size() == 0);
    REQUIRE(simulation.interface().owned > 0);
}

TEST_CASE("The time step is the smallest Courant limit, or what the scene fixes") {
    const std::string text = preamble(0.002) + water + block;
    const Simulation<2> simulation(scene_text::load(text));
    // K = E/(3 (1 − 2ν)) = 2 MPa, c0 = sqrt(K/ρ) = 42.64 m/s; h = 3 mm; courant 0.9
    REQUIRE(simulation.courant_limits().size() == 2);
    REQUIRE(simulation.courant_limits()[0].dt == Approx(0.9 * 0.003 / 30).epsilon(1e-12));
    REQUIRE(simulation.courant_limits()[1].dt == Approx(0.9 * 0.003 / std::sqrt(2e6 / 1100)).epsilon(1e-12));
    REQUIRE(simulation.time_step() == simulation.courant_limits()[1].dt);
    REQUIRE(Simulation<2>(scene_text::load(text, {"method.time_step=1e-5"})).time_step() == 1e-5);
}

TEST_CASE("The hydrostatic start gives each particle the weight of the water above it") {
    const Simulation<2> simulation(
        scene_text::load("gravity = [0.0, -9.81]\n" + preamble(0.002) + water + "hydrostatic_surface = 0.02\n"));
    const auto& fluid = simulation.fluid();
    for (std::size_t i = 0; i < fluid.owned; ++i) {
        const double p = 1000 * 9.81 * (0.02 - fluid.position[i][1]);
        REQUIRE(fluid.pressure[i] == Approx(p).epsilon(1e-9));  // p from ρ − ρ0: eight digits are lost of sixteen
        REQUIRE(fluid.mass[i] / fluid.density[i] == Approx(4e-6).epsilon(1e-12));
    }
}

TEST_CASE("Single-precision pairs give the same motion within their accuracy") {
    const std::string text = "gravity = [0.0, -9.81]\n" + preamble(0.0025) + R"toml(
[bodies.water]
material = "water"
shape = { box = { min = [-0.05, 0.0], max = [0.0, 0.06] } }
hydrostatic_surface = 0.06
[bodies.gate]
material = "rubber"
shape = { box = { min = [0.0, 0.0], max = [0.01, 0.06] } }
clamp = { box = { min = [0.0, 0.05], max = [0.01, 0.06] } }
)toml";
    Simulation<2> exact(scene_text::load(text)), mixed(scene_text::load(text, {"method.precision=mixed"}));
    advance(exact, 300);
    advance(mixed, 300);
    double moved = 0, apart = 0;
    for (std::size_t id = 0; id < exact.solid().owned; ++id) {
        const Vec<2> a = exact.solid().position[exact.solid_index_of_id()[id]];
        const Vec<2> b = mixed.solid().position[mixed.solid_index_of_id()[id]];
        apart = std::max(apart, norm(a - b));
        moved = std::max(moved, norm(exact.solid().velocity[exact.solid_index_of_id()[id]]) * exact.time());
    }
    REQUIRE(moved > 1e-5);
    REQUIRE(apart < 1e-3 * moved);  // 1e-7 per pair, grown over 300 steps
}

}  // namespace sluice
