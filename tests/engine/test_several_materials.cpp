// Several materials of a medium in one scene: fluids side by side, solids joined, apart, and of different models.
#include <cmath>

#include "engine/scene/rules/effects.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_several_materials {
namespace {

const std::string more_materials = R"toml(
[materials.oil]
kind = "fluid"
density = 900.0
sound_speed = 25.0
[materials.metal]
kind = "solid"
density = 2700.0
youngs_modulus = 2e7
poisson_ratio = 0.3
)toml";

/// Oil on water in a tank, 0.1 m wide, each 0.05 m deep.
std::string oil_on_water() {
    return with_gravity + preamble(0.005) + more_materials + mirror_floor + R"toml(
[walls.left]
kind = "mirror"
point = [0.0, 0.0]
normal = [1.0, 0.0]
[walls.right]
kind = "mirror"
point = [0.1, 0.0]
normal = [-1.0, 0.0]
)toml" + water_box("0.0, 0.0", "0.1, 0.05") +
           "hydrostatic_surface = 0.05\npressure = \"900*9.81*0.05\"\n" +
           box_body("oil", "oil", "0.0, 0.05", "0.1, 0.1") + "hydrostatic_surface = 0.1\n";
}

double momentum_error(const Simulation<2>& s, const Vec<2>& start) {
    double size = 0;
    for (const auto* set : {&s.fluid(), &s.solid()})
        for (std::size_t i = 0; i < set->owned; ++i) size += set->mass[i] * norm(set->velocity[i]);
    return norm(s.momentum() - start) / size;
}

}  // namespace

TEST_CASE("Oil rests on water: no mixing, the pressure of both layers", "[materials]") {
    const std::string preset = GENERATE("paper", "modern");
    CAPTURE(preset);
    Simulation<2> s(scene_text::load(oil_on_water(), {"method.preset=" + preset}));
    REQUIRE(s.effects().has(Effect::several_fluids));
    REQUIRE(s.courant_limits().size() == 2);
    // The paper's scheme lets sound ring: the pressure is that of the mean over some of its periods.
    double sum = 0, count = 0;
    while (s.time() < 0.4) {
        s.step();
        if (s.time() < 0.2) continue;
        for (std::size_t i = 0; i < s.fluid().owned; ++i)
            if (s.fluid().body[i] == 0) sum += s.fluid().pressure[i], count += 1;
    }
    const auto& fluid = s.fluid();
    double kinetic = 0, mass = 0;
    for (std::size_t i = 0; i < fluid.owned; ++i) {
        const bool is_oil = fluid.body[i] == 1;
        // Within half a spacing of where the layers meet.
        if (is_oil) REQUIRE(fluid.position[i][1] > 0.05 - 0.0025);
        if (!is_oil) REQUIRE(fluid.position[i][1] < 0.05 + 0.0025);
        kinetic += 0.5 * fluid.mass[i] * norm2(fluid.velocity[i]);
        mass += fluid.mass[i];
    }
    CHECK(std::sqrt(2 * kinetic / mass) < 0.005 * std::sqrt(9.81 * 0.1));
    // In the mean over the water. The layers settle by a percent of their depth, as one fluid does.
    CHECK(sum / count == Approx(9.81 * (900 * 0.05 + 1000 * 0.025)).epsilon(0.02));
}

TEST_CASE("Heavy and light fluid change places at the speed of a gravity current", "[materials]") {
    // Lock exchange: Benjamin 1968 has ½ √(g' H) less friction, experiments 0.44 to 0.5; 50 spacings deep it is 0.43
    // along the floor and 0.50 along the top, here, 20 deep, less.
    std::string scene = with_gravity + preamble(0.005) + more_materials + mirror_floor + R"toml(
[walls.left]
kind = "mirror"
point = [0.0, 0.0]
normal = [1.0, 0.0]
[walls.right]
kind = "mirror"
point = [0.6, 0.0]
normal = [-1.0, 0.0]
)toml" + water_box("0.0, 0.0", "0.3, 0.1") +
                        "hydrostatic_surface = 0.1\n" + box_body("oil", "oil", "0.3, 0.0", "0.6, 0.1") +
                        "hydrostatic_surface = 0.1\n";
    Simulation<2> s(scene_text::load(
        scene, {"method.preset=modern", "materials.water.sound_speed=15", "materials.oil.sound_speed=15"}));
    const double speed = std::sqrt(0.1 * 9.81 * 0.1);  // √(g' H)
    const auto front = [&] {
        double farthest = 0;
        for (std::size_t i = 0; i < s.fluid().owned; ++i)
            if (s.fluid().body[i] == 0) farthest = std::max(farthest, s.fluid().position[i][0]);
        return farthest;
    };
    while (s.time() < 0.4) s.step();
    const double start = front(), at = s.time();
    while (s.time() < 1.0) s.step();
    const double froude = (front() - start) / (s.time() - at) / speed;
    CHECK(froude > 0.34);
    CHECK(froude < 0.5);
}

TEST_CASE("Joined solids of different materials fly and swing as one: momentum and energy kept", "[materials]") {
    // A bar of rubber and metal in two layers, set into bending and free to fly.
    const std::string scene = preamble(0.002) + more_materials + "[bodies.rubber]\nmaterial = \"rubber\"\n" +
                              "shape = {box = {min = [0.0, 0.0], max = [0.06, 0.008]}}\n" +
                              "velocity = [\"0\", \"2*(x/0.06-0.5)^2\"]\n[bodies.metal]\nmaterial = \"metal\"\n" +
                              "shape = {box = {min = [0.0, 0.008], max = [0.06, 0.016]}}\n" +
                              "velocity = [\"0\", \"2*(x/0.06-0.5)^2\"]\n";
    Simulation<2> s(scene_text::load(scene, {"method.preset=modern", "method.solid.artificial_viscosity=0"}));
    REQUIRE(s.effects().has(Effect::several_solids));
    const Vec<2> momentum = s.momentum();
    const double energy = s.energy().total();
    double elastic = 0;
    for (int n = 0; n < 600; ++n) {
        s.step();
        elastic = std::max(elastic, s.energy().elastic);
        REQUIRE(std::abs(s.energy().total() - energy) < 2e-3 * energy);  // symplectic: it swings by (ω Δt)²
    }
    CHECK(momentum_error(s, momentum) < 1e-12);
    CHECK(elastic > 0.05 * energy);
    CHECK(s.energy().contact == 0);
}

TEST_CASE("Solids of different materials, or models, collide: momentum and energy kept", "[materials]") {
    const std::string model = GENERATE("st-venant-kirchhoff", "hypoelastic");
    CAPTURE(model);
    const std::string scene =
        preamble(0.002) + more_materials +
        "[bodies.left]\nmaterial = \"metal\"\nshape = {box = {min = [0.0, 0.0], max = [0.02, 0.02]}}\n"
        "velocity = [1.0, 0.0]\n"
        "[bodies.right]\nmaterial = \"rubber\"\nshape = {box = {min = [0.024, 0.002], max = [0.044, 0.022]}}\n";
    Simulation<2> s(
        scene_text::load(scene, {"method.preset=modern", "method.precision=double",
                                 "method.solid.artificial_viscosity=0", "materials.rubber.model=" + model}));
    const Vec<2> momentum = s.momentum();
    const double energy = s.energy().total();
    double contact = 0, lost = 0;
    while (s.time() < 0.012) {
        s.step();
        contact = std::max(contact, s.energy().contact);
        lost = std::max(lost, std::abs(s.energy().total() - energy));
    }
    CHECK(contact > 1e-3 * energy);  // they met
    CHECK(s.energy().contact == 0);  // and parted
    CHECK(momentum_error(s, momentum) < 1e-12);
    CHECK(lost < (model == "hypoelastic" ? 0.05 : 0.01) * energy);  // the staggered scheme is of first order
    double left = 0, right = 0, m_left = 0, m_right = 0;
    for (std::size_t i = 0; i < s.solid().owned; ++i) {
        (s.solid().body[i] == 0 ? left : right) += s.solid().mass[i] * s.solid().velocity[i][0];
        (s.solid().body[i] == 0 ? m_left : m_right) += s.solid().mass[i];
    }
    CHECK(right / m_right > left / m_left);  // neither went through the other
}

TEST_CASE("Water meets solids of both models in one scene", "[materials]") {
    const std::string scene = with_gravity + preamble(0.004) + more_materials + mirror_floor + R"toml(
[materials.gum]
kind = "solid"
density = 1200.0
youngs_modulus = 8e5
poisson_ratio = 0.4
model = "hypoelastic"
[bodies.water]
material = "water"
hydrostatic_surface = 0.08
shape = {difference = [{box = {min = [0.0, 0.0], max = [0.16, 0.08]}},
                       {box = {min = [0.02, 0.0], max = [0.06, 0.024]}}, {box = {min = [0.1, 0.0], max = [0.14, 0.024]}}]}
[bodies.plate]
material = "metal"
shape = {box = {min = [0.02, 0.0], max = [0.06, 0.012]}}
[bodies.block]
material = "rubber"
shape = {box = {min = [0.02, 0.012], max = [0.06, 0.024]}}
[bodies.lump]
material = "gum"
shape = {box = {min = [0.1, 0.0], max = [0.14, 0.024]}}
clamp = {box = {min = [0.1, 0.0], max = [0.14, 0.008]}}
[walls.left]
kind = "mirror"
point = [0.0, 0.0]
normal = [1.0, 0.0]
[walls.right]
kind = "mirror"
point = [0.16, 0.0]
normal = [-1.0, 0.0]
)toml";
    const std::string coupling = GENERATE("moving-boundary", "interface-force");
    CAPTURE(coupling);
    Simulation<2> s(scene_text::load(
        scene, {"method.preset=modern", "materials.rubber.model=neo-hookean", "method.coupling=" + coupling}));
    CHECK(s.effects().has(Effect::solid_stress));
    CHECK(s.effects().has(Effect::total_lagrangian));
    while (s.time() < 0.05) s.step();
    // Weight of the water above each: 0.04 m wide, 0.056 m of it.
    const double weight = 1000 * 9.81 * 0.056 * 0.04;
    Vec<2> on_pile = s.force_on(1);
    on_pile += s.force_on(2);
    CHECK(on_pile[1] == Approx(-weight).epsilon(0.15));  // sound runs up and down the tank
    CHECK(s.force_on(3)[1] == Approx(-weight).epsilon(0.15));
    CHECK(s.interface_balance().residual < 1e-9);
}

TEST_CASE("Fluids that pairs are not defined for are refused", "[materials]") {
    CHECK_THROWS_WITH(Simulation<2>(scene_text::load(oil_on_water(), {"materials.oil.viscosity=0.01"})),
                      Catch::Contains("materials.oil.viscosity") && Catch::Contains("kinematic viscosity"));
    CHECK_THROWS_WITH(Simulation<2>(scene_text::load(oil_on_water(), {"method.fluid.density_diffusion=antuono"})),
                      Catch::Contains("density_diffusion") && Catch::Contains("fourtakas"));
}

}  // namespace sluice::test_several_materials
