// Water at rest against a solid: the load is the hydrostatic one, at the start and after many steps.
#include <fmt/format.h>

#include "tests/catch.hpp"
#include "tests/engine/collision_scenes.hpp"

namespace sluice::test_coupled_rest {
namespace {

/// Water 0.1 m deep against a clamped wall on its right; mirrored floor and back.
std::string dam() {
    return with_gravity + preamble(0.005) + water_box("0.0, 0.0", "0.1, 0.1") + "hydrostatic_surface = 0.1\n" +
           box_body("wall", "rubber", "0.1, 0.0", "0.12, 0.14") +
           "clamp = { box = { min = [0.1, 0.0], max = [0.12, 0.14] } }\n" + mirror_floor + mirror_back("0.0");
}

/// Without any dissipation the layer at a moving boundary grows rough within some 500 steps, until it boils.
const std::string method_of_rest = "method.fluid.density_diffusion=fourtakas";

}  // namespace

TEST_CASE("A clamped solid bears the hydrostatic load, at once and after a while, with either coupling and model") {
    const std::string coupling = GENERATE("interface-force", "moving-boundary");
    const std::string model = GENERATE("hypoelastic", "st-venant-kirchhoff");
    CAPTURE(coupling, model);
    const double expected = 0.5 * 1000 * 9.81 * 0.1 * 0.1;
    Simulation<2> s(scene_text::load(dam(), {"method.coupling=" + coupling, "materials.rubber.model=" + model,
                                             method_of_rest, "method.fluid.velocity_filter=1"}));
    s.step();
    CHECK(s.force_on(1)[0] == Approx(expected).epsilon(0.02));  // two per cent of the sums at 0.05 of the depth
    advance(s, 600);
    double mean = 0;
    for (int n = 0; n < 100; ++n) {
        s.step();
        mean += s.force_on(1)[0] / 100;
    }
    CAPTURE(mean / expected);
    CHECK(mean == Approx(expected).epsilon(0.05));  // the water has settled by a per cent or two at its surface
    // Far below sqrt(gH) = 1 m/s; the interface's force leaves more motion than the moving boundary.
    CHECK(std::sqrt(2 * kinetic_energy_per_mass(s)) < 0.08);
}

TEST_CASE("Clamped particles are not accelerated, whatever presses on them") {
    const std::string model = GENERATE("hypoelastic", "st-venant-kirchhoff");
    Simulation<2> s(scene_text::load(
        dam(), {"method.coupling=moving-boundary", "materials.rubber.model=" + model, method_of_rest}));
    advance(s, 5);
    for (std::size_t i = 0; i < s.boundary().owned; ++i) CHECK(s.boundary().mean_acceleration[i] == Vec<2>{});
}

TEST_CASE("The fluid sees a free solid's acceleration: elastic, gravity's and its own pressure's together") {
    // In free fall nothing else acts; a block that water pushes is accelerated by the force over its mass.
    const std::string model = GENERATE("hypoelastic", "st-venant-kirchhoff");
    Simulation<2> s(scene_text::load(collisions::flat(), {"method.coupling=moving-boundary", "method.time_step=3e-5",
                                                          "materials.rubber.model=" + model}));
    CAPTURE(model);
    Vec<2> force, change;
    advance(s, 20);
    for (int n = 0; n < 50; ++n) {
        force += s.force_on(1);  // constant over the step to come
        s.step();
        const auto& solid = s.solid();
        for (std::size_t i = 0; i < solid.owned; ++i) change += solid.mass[i] * solid.mean_acceleration[i];
    }
    REQUIRE(norm(force) > 0);
    CHECK(norm(change - force) < 1e-9 * norm(force));  // elastic forces cancel
}

TEST_CASE("Fluid that falls with a solid feels nothing of it") {
    const std::string model = GENERATE("hypoelastic", "st-venant-kirchhoff");
    Simulation<2> s(scene_text::load(
        with_gravity + preamble(0.0025) + water_box("0.0, 0.0", "0.03, 0.03") + rubber_box("0.0, -0.01", "0.03, 0.0"),
        {"method.coupling=moving-boundary", "materials.rubber.model=" + model, "method.solid.artificial_viscosity=0"}));
    advance(s, 20);
    // At the start the block is not yet known to fall, so that the water leans on it for one step; that fades.
    const double weight = 1000 * 9.81 * 0.03 * 0.03;
    CHECK(norm(s.force_on(1)) < 0.02 * weight);
}

TEST_CASE("A light solid in heavy water stays bounded") {
    const double density = GENERATE(1100.0, 500.0, 250.0);
    CAPTURE(density);
    Simulation<2> s(scene_text::load(collisions::flat(),
                                     collisions::coupled({fmt::format("materials.rubber.density={}", density)})));
    const double start = s.energy().total();
    double highest = start;
    while (s.time() < 0.01) {
        s.step();
        highest = std::max(highest, s.energy().total());
    }
    CAPTURE(highest / start);
    CHECK(highest < 1.05 * start);  // the force is extrapolated with the last step's acceleration
}

}  // namespace sluice::test_coupled_rest
