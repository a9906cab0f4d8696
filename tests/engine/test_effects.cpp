// Which effects a scene calls for, what is allocated for them, and the time step.
#include "engine/scene/rules/effects.hpp"

#include "engine/particles/id_index.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_effects {
namespace {

const std::string water = water_box("0.0, 0.0", "0.02, 0.02"), block = rubber_box("0.03, 0.0", "0.05, 0.02");

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
        scene_text::load(with_gravity + preamble(0.002) + water + "hydrostatic_surface = 0.02\n"));
    const auto& fluid = simulation.fluid();
    for (std::size_t i = 0; i < fluid.owned; ++i) {
        const double p = 1000 * 9.81 * (0.02 - fluid.position[i][1]);
        REQUIRE(fluid.pressure[i] == Approx(p).epsilon(1e-9));  // p from ρ − ρ0: eight digits are lost of sixteen
        REQUIRE(fluid.mass[i] / fluid.density[i] == Approx(4e-6).epsilon(1e-12));
    }
}

TEST_CASE("Single-precision pairs give the same motion within their accuracy") {
    const std::string text = with_gravity + preamble(0.0025) + water_at_gate("-0.05");
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

namespace {

/// Every coordinate and velocity after some steps, in the order of the particles' ids.
std::vector<double> motion_of(const std::string& text, const std::vector<std::string>& overrides) {
    Simulation<2> simulation(scene_text::load(text, overrides));
    advance(simulation, 20);
    std::vector<double> values;
    const auto add = [&](const auto& phase) {
        const std::size_t first = values.size();
        values.resize(first + 4 * phase.owned);
        for (std::size_t i = 0; i < phase.owned; ++i)
            for (int k = 0; k < 2; ++k) {
                const std::size_t at = first + 4 * phase.id[i] + static_cast<std::size_t>(k);
                values[at] = phase.position[i][k];
                values[at + 2] = phase.velocity[i][k];
            }
    };
    add(simulation.fluid());
    add(simulation.solid());
    return values;
}

struct OffSwitch {
    const char* effect;
    const char* constant;              ///< what takes the effect out of the scene otherwise
    std::vector<std::string> present;  ///< what it needs to act
};

/// A light solid at its own rate, which bears a steady load and has a viscosity for that.
const std::vector<std::string> light_solid{"method.preset=modern", "materials.rubber.density=500"};

/// Everything moves and shears, so that no term vanishes by itself.
const std::string shearing = with_gravity + preamble(0.002) + water + "velocity = [\"10*y\", \"-0.2+5*x\"]\n" + block +
                             "velocity = [\"10*y\", \"0.2-5*x\"]\n";

}  // namespace

TEST_CASE("An effect switched off is the same, to the bit, as one whose constant takes it out") {
    const OffSwitch off = GENERATE(values<OffSwitch>({
        {"artificial_viscosity", "method.fluid.artificial_viscosity=0", {"method.fluid.artificial_viscosity=0.1"}},
        {"acoustic_damping", "method.fluid.acoustic_damping=0", {"method.fluid.acoustic_damping=0.5"}},
        {"density_diffusion", "method.fluid.density_diffusion=none", {"method.fluid.density_diffusion=antuono"}},
        {"velocity_filter", "method.fluid.velocity_filter=1", {}},
        {"particle_shifting", "method.fluid.particle_shifting=0", {"method.fluid.particle_shifting=2"}},
        {"laminar_viscosity", "materials.water.viscosity=0", {"materials.water.viscosity=0.1"}},
        {"solid_viscosity", "method.solid.artificial_viscosity=0", {}},
        {"solid_viscosity",
         "method.solid.artificial_viscosity=0",
         {"materials.rubber.model=neo-hookean", "method.solid.artificial_viscosity=1"}},
        {"hourglass_control", "method.solid.hourglass_control=0", {"materials.rubber.model=neo-hookean"}},
        {"artificial_stress", "method.solid.artificial_stress=0", {}},
        {"solid_filter", "method.solid.velocity_filter=1", {"method.solid.velocity_filter=0.9"}},
        {"gravity", "gravity=[0.0,0.0]", {}},
        {"adaptive_step", "method.step_size=fixed", {"method.step_size=adaptive", "method.time_stepping=multi-rate"}},
        {"solid_substeps", "method.time_stepping=single-rate", {"method.time_stepping=multi-rate"}},
        {"solid_substeps", "method.time_stepping=single-rate", light_solid},
    }));
    INFO(off.effect);
    std::vector<std::string> with = off.present, without = off.present, switched = off.present;
    without.emplace_back(off.constant);
    switched.push_back(std::string("effects.") + off.effect + "=off");
    REQUIRE(motion_of(shearing, switched) == motion_of(shearing, without));
    REQUIRE(motion_of(shearing, switched) != motion_of(shearing, with));
}

TEST_CASE("The solid's own rate switched on is the same, to the bit, as one that the method calls for") {
    std::vector<std::string> single = light_solid;
    single.emplace_back("method.time_stepping=single-rate");
    std::vector<std::string> switched = single;
    switched.emplace_back("effects.solid_substeps=on");
    REQUIRE(motion_of(shearing, switched) == motion_of(shearing, light_solid));
    REQUIRE(motion_of(shearing, switched) != motion_of(shearing, single));
}

}  // namespace sluice::test_effects
