// Hydrostatics: water at rest between walls of each kind stays at rest and bears on them with its weight.
#include <cmath>

#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_water_at_rest {
namespace {

const std::string fixed_tub = R"toml(
[walls.tub]
kind = "fixed"
shape = { difference = [{ box = { min = [-0.016, -0.016], max = [0.116, 0.132] } }, { box = { min = [0.0, 0.0], max = [0.1, 0.14] } }] }
)toml";

std::string water_column(double spacing, const std::string& walls) {
    return "gravity = [0.0, -9.81]\n" + preamble(spacing) + R"toml(
[bodies.water]
material = "water"
shape = { box = { min = [0.0, 0.0], max = [0.1, 0.1] } }
hydrostatic_surface = 0.1
)toml" + walls;
}

/// Mean pressure of the fluid particles between two heights.
double mean_pressure(const Simulation<2>& s, double low, double high) {
    double sum = 0;
    int n = 0;
    for (std::size_t i = 0; i < s.fluid().owned; ++i) {
        const double y = s.fluid().position[i][1];
        if (y < low || y > high) continue;
        sum += s.fluid().pressure[i];
        ++n;
    }
    return sum / n;
}

}  // namespace

TEST_CASE("Water between mirror walls stays at rest under its own pressure") {
    Simulation<2> simulation(scene_text::load(water_column(0.004, mirror_floor + mirror_sides("0.1"))));
    advance(simulation, 1500);  // 0.27 s: forty times the sound's way through the column
    // Without viscosity the free surface's kernel error leaves some motion; it must stay far below sqrt(gH) ≈ 1 m/s.
    REQUIRE(std::sqrt(2 * kinetic_energy_per_mass(simulation)) < 0.02);
    REQUIRE(mean_pressure(simulation, 0.0, 0.02) == Approx(1000 * 9.81 * 0.09).epsilon(0.03));
    REQUIRE(mean_pressure(simulation, 0.04, 0.06) == Approx(1000 * 9.81 * 0.05).epsilon(0.03));
}

TEST_CASE("Water in a tub of fixed ghosts stays at rest and inside") {
    Simulation<2> simulation(scene_text::load(water_column(0.004, fixed_tub)));
    advance(simulation, 1500);
    REQUIRE(std::sqrt(2 * kinetic_energy_per_mass(simulation)) < 0.05);
    REQUIRE(mean_pressure(simulation, 0.0, 0.02) == Approx(1000 * 9.81 * 0.09).epsilon(0.05));
    for (std::size_t i = 0; i < simulation.fluid().owned; ++i) {
        const Vec<2> x = simulation.fluid().position[i];
        REQUIRE((x[0] > 0 && x[0] < 0.1 && x[1] > 0 && x[1] < 0.11));
    }
}

TEST_CASE("No particle passes a mirror wall, however hard it is thrown") {
    Simulation<2> simulation(scene_text::load(preamble(0.004) + R"toml(
[bodies.water]
material = "water"
shape = { box = { min = [0.0, 0.01], max = [0.04, 0.05] } }
velocity = [0.0, -3.0]
)toml" + mirror_floor,
                                              {"method.mach_limit=0.2", "method.expected_speed=3"}));
    advance(simulation, 400);
    for (std::size_t i = 0; i < simulation.fluid().owned; ++i) REQUIRE(simulation.fluid().position[i][1] > 0);
}

TEST_CASE("Hydrostatic pressure loads a wall of solid particles with its resultant, at any spacing") {
    // A clamped wall 0.1 m high, water 0.1 m deep on one side, floor mirrored: F = ½ ρ g H² by statics.
    const double expected = 0.5 * 1000 * 9.81 * 0.1 * 0.1;
    for (const double spacing : {0.005, 0.0025, 0.00125}) {
        Simulation<2> simulation(scene_text::load(water_column(spacing, mirror_floor + R"toml(
[bodies.wall]
material = "rubber"
shape = { box = { min = [0.1, 0.0], max = [0.11, 0.14] } }
clamp = { box = { min = [0.1, 0.0], max = [0.11, 0.14] } }
)toml")));
        simulation.step();
        CAPTURE(spacing);
        // The particles' pressure is exact at their centres; kernel and surface elements integrate it to under 1 %.
        REQUIRE(simulation.force_on(1)[0] == Approx(expected).epsilon(0.01));
    }
}

}  // namespace sluice::test_water_at_rest
