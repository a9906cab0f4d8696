// In 3D, what the tests of single effects show in 2D: the cheapest scene that tells the effect from its absence.
#include <fmt/format.h>

#include <numbers>

#include "engine/scene/rules/effects.hpp"
#include "kernels/tensor.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_effects_3d {
namespace {

constexpr double spacing = 0.005, side = 0.04;  // [m]
constexpr double sound_speed = 30;              // of the preamble's water [m/s]

/// Water that fills a periodic cube. Nothing but pressure acts on it; `initial` are lines of its body.
std::string periodic_cube(const std::string& initial) {
    return "dimension = 3\n" + preamble(spacing) +
           "[domain]\nperiodic = { x = [0.0, 0.04], y = [0.0, 0.04], z = [0.0, 0.04] }\n" +
           water_box("0.0, 0.0, 0.0", "0.04, 0.04, 0.04") + initial;
}

/// Without the paper's velocity filter, and with velocities that stand at the same time as positions.
std::vector<std::string> plain(std::vector<std::string> more = {}) {
    more.insert(more.end(),
                {"method.preset=paper", "method.fluid.velocity_filter=1", "method.integrator=kick-drift-kick"});
    return more;
}

template <class Phase>
double mass_of(const Phase& phase) {
    double m = 0;
    for (std::size_t i = 0; i < phase.owned; ++i) m += phase.mass[i];
    return m;
}

/// How far the nearest neighbour in the cube is, mean over all particles. [m]
double mean_nearest_distance(const ParticleSet<3>& fluid) {
    double sum = 0;
    for (std::size_t i = 0; i < fluid.owned; ++i) {
        double nearest = side;
        for (std::size_t j = 0; j < fluid.owned; ++j) {
            Vec<3> x = fluid.position[i] - fluid.position[j];
            for (int k = 0; k < 3; ++k) x[k] -= side * std::round(x[k] / side);
            if (i != j) nearest = std::min(nearest, norm(x));
        }
        sum += nearest;
    }
    return sum / static_cast<double>(fluid.owned);
}

}  // namespace

TEST_CASE("In 3D, a shaken cube of water takes up the acceleration's integral", "[3d]") {
    Simulation<3> s(scene_text::load(
        "acceleration = [\"3*sin(100*t)\", \"0.5\", \"-2*cos(50*t)\"]\n" + periodic_cube(""), plain()));
    advance(s, 40);
    const double m = mass_of(s.fluid()), t = s.time();
    // The trapezoidal rule's (ω Δt)²/12 with ω Δt = 0.02; nothing in a linear function.
    CHECK(s.momentum()[0] == Approx(m * 0.03 * (1 - std::cos(100 * t))).epsilon(1e-4));
    CHECK(s.momentum()[1] == Approx(m * 0.5 * t).epsilon(1e-12));
    CHECK(s.momentum()[2] == Approx(-m * 0.04 * std::sin(50 * t)).epsilon(1e-4));
}

TEST_CASE("In 3D, particle shifting keeps particles evenly spaced in a vortex and moves no momentum", "[3d]") {
    const double k = 2 * std::numbers::pi / side;
    const std::string velocity =
        fmt::format("velocity = [\"sin({0}*x)*cos({0}*y)\", \"-cos({0}*x)*sin({0}*y)\", \"0.3*sin({0}*x)\"]\n", k);
    const auto vortex = [&](const char* shifting) {
        return Simulation<3>(
            scene_text::load(periodic_cube(velocity), plain({std::string("method.fluid.particle_shifting=") + shifting,
                                                             "method.fluid.density_diffusion=fourtakas"})));
    };
    Simulation<3> shifted = vortex("2"), drifting = vortex("0");
    for (Simulation<3>* s : {&shifted, &drifting})
        while (s->time() < 0.04) s->step();  // what goes round in it has gone 0.04 m
    const double even = mean_nearest_distance(shifted.fluid()), uneven = mean_nearest_distance(drifting.fluid());
    CAPTURE(even / spacing, uneven / spacing);
    // A cubic lattice has d; particles at random 0.55 d.
    CHECK(even > 0.85 * spacing);
    CHECK(uneven < 0.65 * spacing);
    CHECK(norm(shifted.momentum()) < 1e-3 * mass_of(shifted.fluid()));
}

TEST_CASE("In 3D, fluid at rest is not shifted", "[3d]") {
    Simulation<3> s(scene_text::load(periodic_cube(""), plain({"method.fluid.particle_shifting=2"})));
    const auto before = s.fluid().position;
    advance(s, 20);
    for (std::size_t i = 0; i < s.fluid().owned; ++i) REQUIRE(norm(s.fluid().position[i] - before[i]) < 1e-12);
}

TEST_CASE("In 3D, density diffusion smoothes a checkerboard of densities that pressure cannot see", "[3d]") {
    const std::string kind = GENERATE("none", "molteni-colagrossi", "fourtakas", "antuono");
    CAPTURE(kind);
    // Half-way between the zeros of sin(pi x/d) stand the particles.
    const std::string pressure =
        fmt::format("pressure = \"100 * sin(pi*x/{0}) * sin(pi*y/{0}) * sin(pi*z/{0})\"\n", spacing);
    Simulation<3> s(scene_text::load(periodic_cube(pressure), plain({"method.fluid.density_diffusion=" + kind})));
    const auto& fluid = s.fluid();
    std::vector<double> sign(fluid.owned);
    for (std::size_t i = 0; i < fluid.owned; ++i) sign[fluid.id[i]] = fluid.density[i] > 1000 ? 1 : -1;
    const auto noise = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < fluid.owned; ++i) sum += sign[fluid.id[i]] * (fluid.density[i] - 1000);
        return sum / static_cast<double>(fluid.owned);
    };
    const double start = noise();
    REQUIRE(start == Approx(100 / (sound_speed * sound_speed)).epsilon(1e-6));  // p/c0², to ρ − ρ0's digits
    advance(s, 60);
    // The slowest of the three takes some ten steps to halve it.
    if (kind == "none")
        CHECK(std::abs(noise()) > 0.5 * start);
    else
        CHECK(std::abs(noise()) < 0.02 * start);
}

TEST_CASE("In 3D, acoustic damping takes sound away at the rate alpha c0 h k^2/2", "[3d]") {
    const double alpha = 0.5, length = 0.1, k = 2 * std::numbers::pi / length;
    const std::string sound = fmt::format("velocity = [\"0.01*sin({}*x)\", \"0\", \"0\"]\n", k);
    const auto fading_rate = [&](double damping) {
        Simulation<3> s(
            scene_text::load("dimension = 3\n" + preamble(spacing) +
                                 "[domain]\nperiodic = { x = [0.0, 0.1], y = [0.0, 0.025], z = [0.0, 0.025] }\n" +
                                 water_box("0.0, 0.0, 0.0", "0.1, 0.025, 0.025") + sound,
                             plain({fmt::format("method.fluid.acoustic_damping={}", damping)})));
        const auto energy = [&] { return s.energy().kinetic + s.energy().compression; };
        const double start = energy();
        while (s.time() < 3 * length / sound_speed) s.step();  // three periods
        return 0.5 * std::log(start / energy()) / s.time();
    };
    const double expected = alpha * sound_speed * 1.5 * spacing * k * k / 2;
    CHECK(fading_rate(alpha) == Approx(expected).epsilon(0.2));  // (kh)² = 0.2 of the sums
    CHECK(std::abs(fading_rate(0)) < 0.02 * expected);
}

TEST_CASE("In 3D, the velocity filter takes a checkerboard out of velocities", "[3d]") {
    const std::string noise =
        fmt::format("velocity = [\"0.01*sin(pi*x/{0})*sin(pi*y/{0})*sin(pi*z/{0})\", \"0\", \"0\"]\n", spacing);
    const auto remaining = [&](const char* theta) {
        Simulation<3> s(scene_text::load(
            periodic_cube(noise), {"method.preset=paper", std::string("method.fluid.velocity_filter=") + theta}));
        const auto& fluid = s.fluid();
        std::vector<double> sign(fluid.owned);
        for (std::size_t i = 0; i < fluid.owned; ++i) sign[fluid.id[i]] = fluid.velocity[i][0] > 0 ? 1 : -1;
        advance(s, 30);
        double sum = 0;
        for (std::size_t i = 0; i < fluid.owned; ++i) sum += sign[fluid.id[i]] * fluid.velocity[i][0];
        return std::abs(sum) / (0.01 * static_cast<double>(fluid.owned));
    };
    CHECK(remaining("0.92") < 0.12);  // 0.92³⁰ = 0.08
    CHECK(remaining("1.0") > 0.5);
}

TEST_CASE("In 3D, adaptive steps follow the speed", "[3d]") {
    Simulation<3> s(
        scene_text::load(periodic_cube("velocity = [1.0, 2.0, -2.0]\n"),
                         plain({"method.step_size=adaptive", "method.courant=0.9", "method.expected_speed=3"})));
    advance(s, 5);
    CHECK(s.time_step() == Approx(0.9 * 1.5 * spacing / (sound_speed + 3)).epsilon(1e-9));  // no acceleration, |v| = 3
}

TEST_CASE("In 3D, two refinements of the fluid exchange momentum pairwise", "[3d]") {
    Simulation<3> s(scene_text::load(
        "dimension = 3\n" + preamble(spacing) + box_body("coarse", "water", "-0.04, -0.02, -0.02", "0.0, 0.02, 0.02") +
            "spacing_ratio = 2.0\nvelocity = [1.0, 0.0, 0.1]\n" +
            box_body("fine", "water", "0.005, -0.02, -0.02", "0.025, 0.02, 0.02") + "velocity = [-0.5, 0.2, 0.0]\n",
        plain({"method.fluid.artificial_viscosity=0.1"})));
    REQUIRE(s.effects().has(Effect::variable_resolution));
    const Vec<3> before = s.momentum();
    advance(s, 60);
    CHECK(norm(s.momentum() - before) < 1e-12 * norm(before));  // rounding
    Vec<3> of_fine;
    double mass = 0;
    for (std::size_t i = 0; i < s.fluid().owned; ++i)
        if (s.fluid().body[i] == 1) of_fine += s.fluid().mass[i] * s.fluid().velocity[i], mass += s.fluid().mass[i];
    CHECK(of_fine[0] > -0.4 * mass);  // they do meet: it came with −0.5 m/s
}

TEST_CASE("In 3D, a total-Lagrangian body falls as the textbook says and turns without strain", "[3d]") {
    const std::string model = GENERATE("st-venant-kirchhoff", "neo-hookean");
    CAPTURE(model);
    const auto body = [&](const std::string& velocity, const std::string& head) {
        return Simulation<3>(scene_text::load(
            head + "dimension = 3\n" + preamble(spacing) + rubber_box("-0.02, -0.01, -0.015", "0.02, 0.01, 0.015") +
                "velocity = " + velocity + "\n",
            {"method.preset=paper", "materials.rubber.model=" + model, "method.solid.artificial_viscosity=0"}));
    };
    Simulation<3> falling = body("[0.3, 0.0, -0.1]", "gravity = [0.0, -9.81, 2.0]\n");
    VectorField<3> start;
    start.resize(falling.solid().owned);
    for (std::size_t i = 0; i < start.size(); ++i) start.set(falling.solid().id[i], falling.solid().position[i]);
    advance(falling, 200);
    const double t = falling.time();
    const Vec<3> path{{0.3 * t, -0.5 * 9.81 * t * t, -0.1 * t + t * t}};
    for (std::size_t i = 0; i < start.size(); ++i)  // kick, drift, kick is exact for a constant force
        REQUIRE(norm(falling.solid().position[i] - start[falling.solid().id[i]] - path) < 1e-9 * norm(path));

    // About an axis that is none of the lattice's: ω = 50/√3 (1, 1, 1).
    Simulation<3> turning = body("[\"28.87*(z-y)\", \"28.87*(x-z)\", \"28.87*(y-x)\"]", "");
    const double energy = turning.energy().total();
    double worst = 0, strain = 0;
    while (turning.time() < 0.03) {  // a quarter turn
        turning.step();
        worst = std::max(worst, std::abs(turning.energy().total() / energy - 1));
        for (std::size_t i = 0; i < turning.solid().owned; ++i) {
            const Tensor<3> f = tensor_of<3>(turning.solid().deformation[i]);
            strain = std::max(strain, (f.transpose() * f - Tensor<3>::Identity()).norm());
        }
    }
    CAPTURE(worst, strain);
    // As in 2D: Verlet's energy swings by (ω' Δt)²/8 of what the breathing of the body holds.
    CHECK(worst < 2e-5);
    // ρ ω² R²/2 = 1 kPa of 1.2 MPa strain it by 8e-4, twice that as the body swings about it; FᵀF doubles it.
    CHECK(strain < 4e-3);
}

TEST_CASE("In 3D, a piston gives the fluid the momentum of the sound wave that it sends out", "[3d]") {
    const double speed = 0.2;
    Simulation<3> s(scene_text::load("dimension = 3\n" + preamble(spacing) +
                                         "[domain]\nperiodic = { y = [0.0, 0.025], z = [0.0, 0.025] }\n" +
                                         water_box("0.0, 0.0, 0.0", "0.1, 0.025, 0.025") + R"toml(
[walls.piston]
kind = "fixed"
shape = { box = { min = [-0.02, 0.0, 0.0], max = [0.0, 0.025, 0.025] } }
motion = { displacement = ["0.2*t", "0", "0"] }
)toml",
                                     plain()));
    REQUIRE(s.effects().has(Effect::moving_wall));
    while (s.time() < 0.8 * 0.1 / sound_speed) s.step();  // the wave has not yet reached the free end
    // Behind the front the fluid moves as the piston does: momentum ρ c V t per area.
    const double expected = 1000 * sound_speed * speed * s.time() * 0.025 * 0.025;
    CAPTURE(s.momentum()[0] / expected);
    CHECK(s.momentum()[0] == Approx(expected).epsilon(0.06));  // half of the first step's share of 12
    for (int k = 1; k < 3; ++k) CHECK(std::abs(s.momentum()[k]) < 1e-9 * expected);
    for (std::size_t i = 0; i < s.fluid().owned; ++i) CHECK(s.fluid().position[i][0] > speed * s.time());
}

TEST_CASE("In 3D, clamped solids as moving boundary and fixed walls hold the same water up", "[3d]") {
    const std::string floor = GENERATE("[walls.floor]\nkind = \"fixed\"\n", "[bodies.floor]\nmaterial = \"rubber\"\n");
    const bool solid = floor.find("rubber") != std::string::npos;
    CAPTURE(solid);
    const std::string box = "{ box = { min = [0.0, -0.02, 0.0], max = [0.025, 0.0, 0.025] } }\n";
    Simulation<3> s(scene_text::load("gravity = [0.0, -9.81, 0.0]\ndimension = 3\n" + preamble(spacing) +
                                         "[domain]\nperiodic = { x = [0.0, 0.025], z = [0.0, 0.025] }\n" +
                                         water_box("0.0, 0.0, 0.0", "0.025, 0.05, 0.025") +
                                         "hydrostatic_surface = 0.05\n" + floor + "shape = " + box +
                                         (solid ? "clamp = " + box : ""),
                                     plain({"method.fluid.density_diffusion=fourtakas",
                                            "method.coupling=moving-boundary", "materials.rubber.model=neo-hookean"})));
    const double weight = mass_of(s.fluid()) * 9.81;
    Vec<3> load;
    const int steps = 200;
    for (int n = 0; n < steps; ++n) {
        s.step();
        if (solid) load += (1.0 / steps) * s.force_on(1);
    }
    if (solid) CHECK(-load[1] == Approx(weight).epsilon(0.01));   // the settling of the first steps
    CHECK(std::abs(s.momentum()[1]) < 0.01 * weight * s.time());  // of what it would have if nothing held it
    for (std::size_t i = 0; i < s.fluid().owned; ++i) CHECK(s.fluid().position[i][1] > 0);
}

}  // namespace sluice::test_effects_3d
