// What is steady in the water's load acts within the solid's own steps.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "engine/simulation/simulation.hpp"
#include "engine/step/parts/steady_load.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_steady_load {
namespace {

constexpr double length = 0.1, thickness = 0.01, depth = 0.02, youngs = 1.7e10, density = 2700;

/// Water on a plate of metal, clamped on both sides, whose slowest motion takes less than a step of the water.
std::string pool() {
    const double d = thickness / 4;
    const std::string sides = mirror_sides(fmt::format("{}", length));
    return fmt::format(R"toml(
gravity = [0.0, -9.81]
[method]
preset = "modern"
precision = "double"
spacing = {0}
[effects]
contact = "off"
[materials.water]
kind = "fluid"
density = 1000.0
sound_speed = 10.0
[materials.metal]
kind = "solid"
density = {1}
youngs_modulus = {2}
poisson_ratio = 0.0
[bodies.water]
material = "water"
shape = {{ box = {{ min = [0.0, 0.0], max = [{3}, {4}] }} }}
hydrostatic_surface = {4}
[bodies.plate]
material = "metal"
shape = {{ box = {{ min = [{5}, {6}], max = [{7}, 0.0] }} }}
clamp = {{ union = [{{ box = {{ min = [{5}, {6}], max = [0.0, 0.0] }} }}, {{ box = {{ min = [{3}, {6}], max = [{7}, 0.0] }} }}] }}
[output]
end = 1.0
)toml",
                       d, density, youngs, length, depth, -4 * d, -thickness, length + 4 * d) +
           sides;
}

/// Deflection of the plate's middle under its weight and the water, of the thin plate's; both means over steps.
double sag(const std::vector<std::string>& overrides) {
    Simulation<2> simulation(scene_text::load(pool(), overrides));
    const auto& solid = simulation.solid();
    double deflection = 0, force = 0;
    const int steps = 80, settling = 40;
    for (int n = 0; n < settling + steps; ++n) {
        simulation.step();
        if (n < settling) continue;
        force -= simulation.force_on(1)[1] / steps;
        for (std::size_t i = 0; i < solid.owned; ++i) {
            const Vec<2> x = solid.reference_position[i];
            if (std::abs(x[0] - length / 2) > thickness / 4) continue;
            deflection += (x[1] - solid.position[i][1]) / (8 * steps);  // eight particles
        }
    }
    const double load = force / length + 9.81 * density * thickness;
    const double rigidity = youngs * std::pow(thickness, 3) / 12;
    return deflection / (load * std::pow(length, 4) / (384 * rigidity));
}

}  // namespace

TEST_CASE("A plate that is quicker than the water's steps sags as far as it should") {
    // 1.0509 for the same particles under their weight alone (1.0843 with twice as many across, 1.096 with shear by
    // Timoshenko). As impulses, (ωΔt/2) cot(ωΔt/2) of it: anything.
    const double with = sag({}), without = sag({"effects.steady_load=off"});
    CAPTURE(with, without);
    CHECK(with == Approx(1.0509).epsilon(0.01));
    CHECK(std::abs(without / with - 1) > 0.3);
}

}  // namespace sluice::test_steady_load
