// Choices of the fluid's method that change how it is computed but not what it does.
#include <algorithm>

#include "tests/catch.hpp"
#include "tests/engine/wave_scenes.hpp"

namespace sluice::test_fluid_choices {
namespace {

/// Vortices in a periodic box, as many to the left as to the right.
Simulation<2> vortices(const std::string& shifting) {
    const std::string velocity =
        fmt::format("velocity = [\"sin({0}*x)*cos({0}*y)\", \"-cos({0}*x)*sin({0}*y)\"]", waves::wave_number);
    return Simulation<2>(scene_text::load(
        waves::box(0.005, waves::length, velocity),
        waves::plain({"method.fluid.particle_shifting=" + shifting, "method.fluid.density_diffusion=fourtakas"})));
}

/// How far the nearest neighbour is, mean over all particles. [m]
double mean_nearest_distance(const ParticleSet<2>& fluid) {
    double sum = 0;
    for (std::size_t i = 0; i < fluid.owned; ++i) {
        double nearest = waves::length;
        for (std::size_t j = 0; j < fluid.owned; ++j) {
            Vec<2> x = fluid.position[i] - fluid.position[j];
            for (int k = 0; k < 2; ++k) x[k] -= waves::length * std::round(x[k] / waves::length);
            if (i != j) nearest = std::min(nearest, norm(x));
        }
        sum += nearest;
    }
    return sum / static_cast<double>(fluid.owned);
}

/// A column of water at rest between periodic sides on a mirrored floor.
std::string tank() {
    return "gravity = [0.0, -9.81]\n" + preamble(0.005) + R"toml(
[domain]
periodic = { x = [0.0, 0.06] }
[bodies.water]
material = "water"
shape = { box = { min = [0.0, 0.0], max = [0.06, 0.1] } }
hydrostatic_surface = 0.1
[walls.floor]
kind = "mirror"
point = [0.0, 0.0]
normal = [0.0, 1.0]
)toml";
}

double mean_pressure(const ParticleSet<2>& fluid, double low, double high) {
    double sum = 0;
    int n = 0;
    for (std::size_t i = 0; i < fluid.owned; ++i) {
        if (fluid.position[i][1] < low || fluid.position[i][1] > high) continue;
        sum += fluid.pressure[i];
        ++n;
    }
    return sum / n;
}

}  // namespace

TEST_CASE("Particle shifting keeps particles evenly spaced in a vortex") {
    Simulation<2> shifted = vortices("2"), drifting = vortices("0");
    for (Simulation<2>* s : {&shifted, &drifting}) waves::advance_to(*s, 0.08);
    const double even = mean_nearest_distance(shifted.fluid()), uneven = mean_nearest_distance(drifting.fluid());
    CAPTURE(even, uneven);
    // A square lattice has d; particles at random half of that.
    CHECK(even > 0.65 * 0.005);
    CHECK(uneven < 0.55 * 0.005);
    // It moves particles, not momentum.
    CHECK(norm(shifted.momentum()) < 1e-3);
}

TEST_CASE("Fluid at rest is not shifted") {
    Simulation<2> s(scene_text::load(waves::box(0.005, 0.05, ""), waves::plain({"method.fluid.particle_shifting=2"})));
    const auto before = s.fluid().position;
    advance(s, 20);
    for (std::size_t i = 0; i < s.fluid().owned; ++i) CHECK(norm(s.fluid().position[i] - before[i]) < 1e-12);
}

TEST_CASE("Tait's equation of state is the linear one at small compression") {
    const double speed = 0.03;  // Mach 1e-3
    const auto run = [&](const std::string& equation) {
        Simulation<2> s(scene_text::load(waves::box(0.0025, 0.04, waves::standing_sound(speed)),
                                         waves::plain({"materials.water.equation_of_state=" + equation})));
        waves::advance_to(s, 0.005);
        return waves::amplitude(s, 0, 0);
    };
    const double linear = run("linear"), tait = run("tait");
    CHECK(linear != tait);
    // (γ − 1)/2 Δρ/ρ = 3e-3 of the sound speed at the crest, and its mean over a wave is 0.
    CHECK(tait == Approx(linear).margin(3e-3 * speed));
}

TEST_CASE("A still tank has the same pressure with every smoothing function") {
    const std::string function = GENERATE("cubic-spline", "wendland-c2", "wendland-c4", "quintic-spline");
    CAPTURE(function);
    Simulation<2> s(scene_text::load(tank(), {"method.smoothing_function=" + function}));
    advance(s, 300);
    const double low = mean_pressure(s.fluid(), 0, 0.02), middle = mean_pressure(s.fluid(), 0.04, 0.06);
    CAPTURE(low / (9810 * 0.09), middle / (9810 * 0.05));
    // As in test_water_at_rest.cpp: the free surface's kernel error leaves some motion.
    CHECK(low == Approx(9810 * 0.09).epsilon(0.03));
    CHECK(middle == Approx(9810 * 0.05).epsilon(0.05));
    CHECK(std::sqrt(2 * kinetic_energy_per_mass(s)) < 0.03);
}

}  // namespace sluice::test_fluid_choices
