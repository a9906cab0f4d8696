// Solids in their reference configuration: free fall, rotation, vibration, hourglass modes.
#include <fmt/format.h>

#include "kernels/tensor.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_total_lagrangian {
namespace {

const std::vector<std::string> models{"st-venant-kirchhoff", "neo-hookean"};

std::string free_block(const std::string& velocity, const std::string& head = "") {
    return head + preamble(0.002) + R"toml(
[method.solid]
artificial_viscosity = 0.0
artificial_stress = 0.0
[bodies.block]
material = "rubber"
shape = { box = { min = [-0.02, -0.01], max = [0.02, 0.01] } }
velocity = )toml" +
           velocity + "\n";
}

/// A plate without support whose ends move against its middle.
std::string plate(double speed) {
    return preamble(0.002) + fmt::format(R"toml(
[method.solid]
artificial_viscosity = 0.0
artificial_stress = 0.0
[bodies.plate]
material = "rubber"
shape = {{ box = {{ min = [0.0, -0.005], max = [0.06, 0.005] }} }}
velocity = ["0", "{}*cos(2*pi*x/0.06)"]
)toml",
                                         speed);
}

std::vector<Vec<2>> positions(const Simulation<2>& s) {
    std::vector<Vec<2>> by_id(s.solid().owned);
    for (std::size_t i = 0; i < by_id.size(); ++i) by_id[s.solid().id[i]] = s.solid().position[i];
    return by_id;
}

/// |FᵀF − I|, the largest of all particles.
double largest_strain(const ParticleSet<2>& solid) {
    double largest = 0;
    for (std::size_t i = 0; i < solid.owned; ++i) {
        const Tensor<2> f = tensor_of<2>(solid.deformation[i]);
        largest = std::max(largest, (f.transpose() * f - Tensor<2>::Identity()).norm());
    }
    return largest;
}

}  // namespace

TEST_CASE("A total-Lagrangian body falls as the textbook says") {
    const std::string model = GENERATE(from_range(models));
    Simulation<2> s(
        scene_text::load(free_block("[0.3, 0.0]", "gravity = [0.0, -9.81]\n"), {"materials.rubber.model=" + model}));
    const auto start = positions(s);
    const double before = s.energy().total();
    advance(s, 500);
    const double t = s.time();
    const auto now = positions(s);
    for (std::size_t i = 0; i < now.size(); ++i) {
        // Kick, drift, kick is exact for a constant force; what is left is rounding.
        REQUIRE(now[i][0] - start[i][0] == Approx(0.3 * t).epsilon(1e-10));
        REQUIRE(now[i][1] - start[i][1] == Approx(-0.5 * 9.81 * t * t).epsilon(1e-9));
    }
    REQUIRE(largest_strain(s.solid()) < 1e-11);
    REQUIRE(s.energy().total() == Approx(before).epsilon(1e-10));
}

TEST_CASE("A total-Lagrangian body that turns freely keeps its energy and is strained by its own inertia only") {
    const std::string model = GENERATE(from_range(models));
    const double omega = 50, quarter = 0.5 * 3.14159265358979 / omega;
    Simulation<2> s(scene_text::load(free_block("[\"-50*y\", \"50*x\"]"), {"materials.rubber.model=" + model}));
    const double start = s.energy().total();
    const auto before = positions(s);
    double worst = 0, strain = 0;
    while (s.time() < quarter) {
        s.step();
        worst = std::max(worst, std::abs(s.energy().total() / start - 1));
        strain = std::max(strain, largest_strain(s.solid()));
    }
    CAPTURE(worst, strain);
    // Verlet's energy swings by (ω' Δt)²/8 of what the breathing of the body holds, a thousandth of all.
    CHECK(worst < 1e-4);
    // ρ ω² R²/2 = 550 Pa of 1.2 MPa stretch its middle by 4e-4, twice that as the body swings about it; FᵀF doubles it.
    CHECK(strain < 3e-3);
    const auto after = positions(s);
    // The body is longer by 4e-4 in the mean and so behind by twice that; the last step goes up to ω Δt = 3e-3 too far.
    for (std::size_t i = 0; i < after.size(); ++i)
        CHECK(norm(after[i] - Vec<2>{{-before[i][1], before[i][0]}}) < 0.01 * 0.022);
    CHECK(norm(s.momentum()) < 1e-12);
}

TEST_CASE("A small vibration is the same in all three solid models") {
    // Lengthwise, where the paper's model has the right stiffness too (test_solid_motion.cpp).
    const auto run = [](const std::string& model) {
        Simulation<2> s(scene_text::load(free_block("[\"-0.05*sin(pi*x/0.04)\", \"0\"]"),
                                         {"materials.rubber.model=" + model, "method.time_step=3e-5"}));
        std::vector<double> length;
        for (int n = 0; n < 80; ++n) {
            s.step();
            const auto x = positions(s);
            double sum = 0;
            for (const Vec<2>& p : x) sum += p[0] * std::sin(3.14159265358979 * p[0] / 0.04);
            length.push_back(sum / static_cast<double>(x.size()));
        }
        return length;
    };
    const auto hypoelastic = run("hypoelastic"), kirchhoff = run("st-venant-kirchhoff"), hookean = run("neo-hookean");
    double swing = 0, apart = 0, between = 0;
    for (std::size_t n = 0; n < kirchhoff.size(); ++n) {
        swing = std::max(swing, std::abs(kirchhoff[n] - kirchhoff[0]));
        apart = std::max(apart, std::abs(kirchhoff[n] - hypoelastic[n]));
        between = std::max(between, std::abs(kirchhoff[n] - hookean[n]));
    }
    CAPTURE(swing, apart / swing, between / swing);
    CHECK(swing > 1e-6);
    CHECK(between < 0.02 * swing);  // the strain is 1e-3
    // The ends: two layers of ten, where the paper's plain gradient (11) feels half of the stress.
    CHECK(apart < 0.2 * swing);
}

TEST_CASE("A free total-Lagrangian plate vibrates without losing or gaining energy") {
    const std::string model = GENERATE(from_range(models));
    Simulation<2> s(scene_text::load(plate(0.2), {"materials.rubber.model=" + model}));
    const double start = s.energy().total();
    double lowest = 0, highest = 0, stored = 0;
    while (s.time() < 0.03) {  // four periods
        s.step();
        const EnergyBalance e = s.energy();
        lowest = std::min(lowest, e.total() / start - 1);
        highest = std::max(highest, e.total() / start - 1);
        stored = std::max(stored, e.elastic / start);
    }
    CAPTURE(lowest, highest, stored);
    CHECK(stored > 0.8);  // it does vibrate
    // Verlet at the Courant limit: (ωΔt)²/8 of the bending mode is 1e-5; the rest is in short waves, of which a plate
    // that starts in a smooth shape has few.
    CHECK(highest < 0.01);
    CHECK(lowest > -0.01);
    CHECK(norm(s.momentum()) < 1e-12);
}

TEST_CASE("Hourglass control holds what no gradient sees") {
    // Particles that move against their neighbours, in turn along both axes: F stays the identity on average.
    const std::string velocity = "[\"0.05*sin(pi*(x+0.02)/0.002)*sin(pi*(y+0.01)/0.002)\", \"0\"]";
    const auto run = [&](const std::string& control) {
        Simulation<2> s(scene_text::load(free_block(velocity), {"materials.rubber.model=st-venant-kirchhoff",
                                                                "method.solid.hourglass_control=" + control}));
        const auto start = positions(s);
        const double energy = s.energy().total();
        double largest = 0, worst = 0;
        for (int n = 0; n < 100; ++n) {
            s.step();
            const auto now = positions(s);
            // In the middle, away from the edges by a support.
            for (std::size_t i = 0; i < now.size(); ++i)
                if (std::abs(start[i][0]) < 0.012 && std::abs(start[i][1]) < 0.004)
                    largest = std::max(largest, norm(now[i] - start[i]));
            worst = std::max(worst, std::abs(s.energy().total() / energy - 1));
        }
        return std::array{largest, worst, s.time()};
    };
    const auto held = run("0.1"), free = run("0");
    CAPTURE(held[0], held[1], free[0], free[1], free[2]);
    CHECK(free[0] > 0.5 * 0.05 * free[2]);  // they drift apart, next to unhindered
    CHECK(held[0] < 0.5 * free[0]);
    // What the control holds is part of the energy, which swings by (ωΔt)²/4: the mode's period is some twenty steps.
    CHECK(held[1] < 0.2);
}

TEST_CASE("Bodies too far apart for the search are refused with a message") {
    const std::string text = preamble(0.002) + rubber_box("0.0, 0.0", "0.02, 0.02") +
                             box_body("far", "rubber", "1e9, 0.0", "1000000000.02, 0.02");
    CHECK_THROWS_WITH((Simulation<2>(scene_text::load(text, {"method.preset=modern"}))),
                      Catch::Contains("spread over more cells"));
}

}  // namespace sluice::test_total_lagrangian
