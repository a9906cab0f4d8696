// Particles that have nobody to interact with.
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_few_particles {

TEST_CASE("Particles that fly apart move on in straight lines and stay finite") {
    const char* filter = GENERATE("0.92", "1.0");
    Simulation<2> simulation(scene_text::load(preamble(0.002) + R"toml(
[bodies.left]
material = "water"
shape = { box = { min = [0.0, 0.0], max = [0.002, 0.002] } }
velocity = [-5.0, 0.0]
[bodies.right]
material = "water"
shape = { box = { min = [0.004, 0.0], max = [0.006, 0.002] } }
velocity = [5.0, 1.0]
)toml",
                                              {std::string("method.fluid.velocity_filter=") + filter}));
    const auto apart = [&] { return simulation.fluid().position[1] - simulation.fluid().position[0]; };
    const Vec<2> before = simulation.momentum();
    advance(simulation, 200);
    REQUIRE(norm(apart()) > 0.006);  // beyond the support of 3 d: nobody feels anybody
    const auto velocities = simulation.fluid().velocity;
    advance(simulation, 1000);
    for (std::size_t i = 0; i < 2; ++i) REQUIRE(simulation.fluid().velocity[i] == velocities[i]);
    REQUIRE(norm(simulation.momentum() - before) < 1e-12 * simulation.fluid().mass[0]);
}

TEST_CASE("A single particle of water falls freely") {
    Simulation<2> simulation(scene_text::load("gravity = [0.0, -10.0]\n" + preamble(0.002) + R"toml(
[bodies.drop]
material = "water"
shape = { box = { min = [0.0, 0.0], max = [0.002, 0.002] } }
)toml"));
    advance(simulation, 1000);
    REQUIRE(simulation.fluid().owned == 1);
    const double t = simulation.time();
    REQUIRE(simulation.fluid().position[0][1] ==
            Approx(0.001 - 5 * t * t).epsilon(1e-3));  // first order in the first step
}

}  // namespace sluice::test_few_particles
