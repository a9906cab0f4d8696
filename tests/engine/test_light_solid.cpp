// Solids lighter than the fluid whose moving boundary they are (engine/scene/light_solid.hpp), and viscous ones beside
// a clamp.
#include "engine/scene/light_solid.hpp"

#include <fmt/format.h>

#include "engine/scene/check/suspicion.hpp"
#include "tests/catch.hpp"
#include "tests/engine/collision_scenes.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_light_solid {
namespace {

const std::string tank = R"toml(
title = "Tank"
gravity = [0.0, -9.81]
[method]
spacing = 0.005
expected_speed = 1.4
[materials.water]
kind = "fluid"
density = 1000.0
sound_speed = 20.0
[materials.rubber]
kind = "solid"
density = 100.0
youngs_modulus = 2.0e6
poisson_ratio = 0.4
[output]
end = 1
)toml" + mirror_sides("0.2");

/// Water 0.1 m deep on an elastic floor that is clamped at both ends and starts straight.
const std::string elastic_floor = tank + R"toml(
[effects]
contact = "off"
[bodies.water]
material = "water"
shape = { box = { min = [0.0, 0.0], max = [0.2, 0.1] } }
hydrostatic_surface = 0.1
[bodies.floor]
material = "rubber"
shape = { box = { min = [-0.02, -0.02], max = [0.22, 0.0] } }
clamp = { union = [{ box = { min = [-0.02, -0.02], max = [0.0, 0.0] } }, { box = { min = [0.2, -0.02], max = [0.22, 0.0] } }] }
)toml";

/// A block, a fifth of the water's density, a fifth of it in the water.
const std::string floating_block = tank + mirror_floor + R"toml(
[bodies.water]
material = "water"
shape = { difference = [{ box = { min = [0.0, 0.0], max = [0.2, 0.1] } }, { box = { min = [0.05, 0.09], max = [0.15, 0.14] } }] }
hydrostatic_surface = 0.1
[bodies.block]
material = "rubber"
shape = { box = { min = [0.05, 0.09], max = [0.15, 0.14] } }
)toml";

std::string density(double value) { return fmt::format("materials.rubber.density={}", value); }

/// Mean height of a solid's particles between two places along x. [m]
double height(const Simulation<2>& s, double from, double to) {
    double sum = 0, n = 0;
    for (std::size_t i = 0; i < s.solid().owned; ++i) {
        const Vec<2> x = s.solid().position[i];
        if (x[0] < from || x[0] > to) continue;
        sum += x[1];
        n += 1;
    }
    return sum / n;
}

}  // namespace

TEST_CASE("Nothing changes for solids as heavy as the fluid, nor for another coupling") {
    for (const std::vector<std::string>& overrides :
         {std::vector<std::string>{density(900)}, {density(100), "method.coupling=interface-force"}}) {
        const Scene scene = scene_text::load(elastic_floor, overrides);
        const LightSolid light = light_solid(scene);
        CHECK(light.relaxation == 1);
        CHECK(light.step_share == 1);
        CHECK(scene.method.solid.artificial_viscosity == 0.1);
    }
}

TEST_CASE("A light solid's boundary goes to its acceleration without overshoot, however deep it is in the fluid") {
    for (const double rho : {50.0, 100.0, 500.0, 800.0}) {
        const double beta = light_solid(scene_text::load(elastic_floor, {density(rho)})).relaxation;
        for (const double kappa : {0.0, 0.5, 1.0}) {
            const double factor = 1 - beta * (1 + kappa * 1000 / rho);
            CAPTURE(rho, kappa);
            CHECK(factor >= -1e-15);  // rounding at κ = 1
            CHECK(factor < 1);
        }
    }
}

TEST_CASE("The viscosity that a light solid needs is a default: the scene may state another, and one rate needs none") {
    const auto viscosity = [](const std::vector<std::string>& overrides) {
        return scene_text::load(elastic_floor, overrides).method.solid.artificial_viscosity;
    };
    CHECK(viscosity({density(500)}) == Approx(0.8));
    CHECK(viscosity({density(100)}) == 1);
    CHECK(viscosity({density(100), "method.solid.artificial_viscosity=0"}) == 0);
    CHECK(viscosity({density(100), "method.time_stepping=single-rate"}) == 0.1);
    CHECK(viscosity({density(100), "effects.solid_substeps=off"}) == 0.1);
    CHECK(viscosity({density(100), "method.time_stepping=single-rate", "effects.solid_substeps=on"}) == 1);
}

TEST_CASE("A light floor swings with the water's mass") {
    // The lowest mode and the sag of a clamped Timoshenko beam under the pressure of ideal water with a free surface,
    // which is a sum over cos(n π x/L): ρ_f H for n = 0, ρ_f tanh(k H)/k for the others.
    struct Theory {
        double density, period, sag;
    };
    const Theory theory = GENERATE(Theory{100, 0.08736, 3.05e-3}, Theory{500, 0.09152, 3.29e-3});
    Simulation<2> s(scene_text::load(elastic_floor, {density(theory.density)}));
    const double start = height(s, 0.09, 0.11);
    const auto below = [&] { return height(s, 0.09, 0.11) - start + theory.sag < 0; };
    std::vector<double> down;  // times at which it passes its place of rest on its way down
    double last = s.time();
    while (down.size() < 3 && s.time() < 0.3) {
        const bool was = below();
        last = s.time();
        s.step();
        if (!was && below()) down.push_back(0.5 * (last + s.time()));
    }
    REQUIRE(down.size() == 3);
    // Four particles across; 0.9 and 1.4 % by a fit over 0.5 s, and steps of 0.2 ms.
    CHECK(0.5 * (down[2] - down[0]) == Approx(theory.period).epsilon(0.03));
}

TEST_CASE("A light block floats at rest where Archimedes says") {
    Simulation<2> s(scene_text::load(floating_block, {density(200)}));
    const double start = height(s, 0, 0.2);
    double farthest = 0;
    while (s.time() < 0.3) {
        s.step();
        farthest = std::max(farthest, std::abs(height(s, 0, 0.2) - start));
    }
    CHECK(farthest < 0.05 * 0.005);  // of a spacing; 0.006 at the end of a second; it was thrown up by 40
    CHECK(s.energy().kinetic < 1e-3);
}

TEST_CASE("A collision with a light block keeps momentum to rounding, with the same bits on any number of threads") {
    const std::vector<std::string> overrides{"method.preset=modern", "method.precision=double", density(110)};
    std::vector<VectorField<2>> solid;
    for (const int threads : {1, 3}) {
        const ThreadScope scope(threads);
        Simulation<2> s(scene_text::load(collisions::flat(), overrides));
        const Vec<2> before = s.momentum();
        double force = 0;
        for (int n = 0; n < 200; ++n) {
            s.step();
            force = std::max(force, norm(s.force_on(1)));
        }
        CHECK(force * s.time() > 0.1 * norm(before));  // they do meet
        CHECK(norm(s.momentum() - before) < 1e-12 * norm(before));
        CHECK(s.interface_balance().residual < 1e-12);
        solid.push_back(s.solid().velocity);
    }
    CHECK(solid[1].c == solid[0].c);
}

TEST_CASE("A solid far lighter than the fluid, and fluid of two spacings, are doubted") {
    const auto doubts = [](const std::string& text, const std::vector<std::string>& overrides) {
        std::string all;
        for (const std::string& doubt : suspicious_values(scene_text::load(text, overrides))) all += doubt + "\n";
        return all;
    };
    using Catch::Contains;
    CHECK_THAT(doubts(floating_block, {density(40)}),
               Contains("materials.rubber.density: found 40 kg/m³, 0.04 of water's 1000 kg/m³"));
    CHECK(doubts(floating_block, {density(50)}).empty());
    const std::string two = floating_block +
                            "[bodies.more]\nmaterial = \"water\"\nspacing_ratio = 2.5\n"
                            "shape = { box = { min = [0.0, 0.2], max = [0.1, 0.3] } }\n";
    CHECK_THAT(doubts(two, {}), Contains("bodies.more.spacing_ratio: found 2.5 times the spacing of bodies.water"));
    CHECK(doubts(two, {"bodies.more.spacing_ratio=2"}).empty());
}

TEST_CASE("A viscous solid beside a clamp that cuts cells is stable at the paper's Courant number") {
    // Without the fastest damping in its step it broke down after 40 steps.
    Simulation<2> s(scene_text::load(R"toml(
title = "Polygon"
[method]
preset = "paper"
spacing = 0.00012314315048817987
[materials.rubber]
kind = "solid"
density = 25.0
youngs_modulus = 35000.0
poisson_ratio = 0.38
model = "neo-hookean"
[bodies.polygon]
material = "rubber"
shape = { polygon = [[0, 0.00020155624253699513], [0.0022165767087872377, 0.00020155624253699513],
  [0.000936805326498891, 0.0020150204662502426], [0, 0.0018599892403912876]] }
clamp = { box = { min = [0, 0.00020155624253699513], max = [0.0022165767087872377, 0.0008665292551731664] } }
velocity = [-0.07, -0.2]
[output]
end = 0.0029
)toml"));
    const double start = s.energy().total();
    double highest = 0;
    while (s.time() < 5e-4) {
        s.step();
        highest = std::max(highest, s.energy().total());
    }
    CHECK(highest < 1.01 * start);
}

}  // namespace sluice::test_light_solid
