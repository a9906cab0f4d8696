// Linear momentum: nothing but gravity, walls and clamps may change it.
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_momentum {
namespace {

double total_mass(const Simulation<2>& s) {
    double m = 0;
    for (std::size_t i = 0; i < s.fluid().owned; ++i) m += s.fluid().mass[i];
    for (std::size_t i = 0; i < s.solid().owned; ++i) m += s.solid().mass[i];
    return m;
}

}  // namespace

TEST_CASE("Water hitting a free elastic body of any shape conserves momentum to rounding") {
    const std::string shape = GENERATE(as<std::string>{}, "{ box = { min = [0.0, -0.015], max = [0.01, 0.015] } }\n",
                                       "{ circle = { centre = [0.017, 0.003], radius = 0.015 } }\n",
                                       "{ polygon = [[0.002, -0.02], [0.03, -0.01], [0.012, 0.025]] }\n",
                                       "{ difference = [{ circle = { centre = [0.018, 0.0], radius = 0.017 } },"
                                       " { circle = { centre = [0.018, 0.0], radius = 0.008 } }] }\n");
    Simulation<2> simulation(scene_text::load(collision(shape)));
    const Vec<2> before = simulation.momentum();
    double largest_force = 0;
    for (int s = 0; s < 300; ++s) {
        simulation.step();
        largest_force = std::max(largest_force, norm(simulation.force_on(1)));
    }
    // The media do meet: the force would bring the water to rest within the time that has passed.
    REQUIRE(largest_force * simulation.time() > 0.1 * norm(before));
    // Rounding of some 10⁵ particle-steps' sums.
    REQUIRE(norm(simulation.momentum() - before) < 1e-12 * norm(before));
    REQUIRE(simulation.interface_balance().residual < 1e-12);
}

TEST_CASE("Two refinements of the fluid exchange momentum pairwise") {
    Simulation<2> simulation(scene_text::load(preamble(0.002) + R"toml(
[method.fluid]
velocity_filter = 1.0
artificial_viscosity = 0.1
[bodies.coarse]
material = "water"
shape = { box = { min = [-0.03, -0.02], max = [0.0, 0.02] } }
spacing_ratio = 2.4
velocity = [1.0, 0.0]
[bodies.fine]
material = "water"
shape = { box = { min = [0.002, -0.02], max = [0.02, 0.02] } }
velocity = [-0.5, 0.2]
)toml"));
    const Vec<2> before = simulation.momentum();
    advance(simulation, 300);
    REQUIRE(norm(simulation.momentum() - before) < 1e-12 * norm(before));
}

TEST_CASE("In free fall momentum grows by weight times time") {
    Simulation<2> simulation(
        scene_text::load(with_gravity + collision("{ circle = { centre = [0.017, 0.0], radius = 0.015 } }\n")));
    const Vec<2> before = simulation.momentum();
    advance(simulation, 200);
    // The velocity of the staggered scheme stands half a step behind the time.
    const double fallen = simulation.time() - 0.5 * simulation.time_step();
    const double expected = before[1] - 9.81 * total_mass(simulation) * fallen;
    REQUIRE(simulation.momentum()[1] == Approx(expected).epsilon(1e-12));
    REQUIRE(simulation.momentum()[0] == Approx(before[0]).epsilon(1e-12));
}

TEST_CASE("Where fluid meets solid at a mirror wall the balance closes with the wall's share") {
    Simulation<2> simulation(scene_text::load(gate_in_basin()));
    advance(simulation, 500);
    REQUIRE(simulation.interface_balance().force > 0);
    REQUIRE(simulation.interface_balance().residual < 1e-12);
}

}  // namespace sluice::test_momentum
