// The order of the schemes in time, and steps that follow what the fluid does.
#include "tests/catch.hpp"
#include "tests/engine/wave_scenes.hpp"

namespace sluice::test_time_integration {
namespace {

/// Positions of a strong standing wave after some time, by id, for a step of end/steps.
std::vector<Vec<2>> positions(int steps, double end, std::vector<std::string> overrides) {
    overrides.push_back(fmt::format("method.time_step={:.17g}", end / steps));
    overrides.push_back("method.fluid.velocity_filter=1");
    Simulation<2> s(scene_text::load(waves::box(0.005, 0.05, waves::standing_sound(0.5)), overrides));
    advance(s, steps);
    std::vector<Vec<2>> by_id(s.fluid().owned);
    for (std::size_t i = 0; i < s.fluid().owned; ++i) by_id[s.fluid().id[i]] = s.fluid().position[i];
    return by_id;
}

double largest_difference(const std::vector<Vec<2>>& a, const std::vector<Vec<2>>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        Vec<2> x = a[i] - b[i];
        x[0] -= waves::length * std::round(x[0] / waves::length);
        x[1] -= 0.05 * std::round(x[1] / 0.05);
        largest = std::max(largest, norm(x));
    }
    return largest;
}

/// log2 of the ratio of two errors, the second for half the step.
double order(double coarse, double fine) { return std::log2(coarse / fine); }

constexpr double end = 0.004;  ///< 1.2 periods of the wave [s]

}  // namespace

TEST_CASE("Kick-drift-kick is of second order in the step") {
    const std::vector<std::string> overrides{"method.integrator=kick-drift-kick"};
    const auto exact = positions(512, end, overrides);
    double error[3];
    for (int k = 0; k < 3; ++k) error[k] = largest_difference(positions(32 << k, end, overrides), exact);
    CAPTURE(error[0], error[1], error[2]);
    CHECK(order(error[0], error[1]) == Approx(2).margin(0.15));
    CHECK(order(error[1], error[2]) == Approx(2).margin(0.15));  // the reference's own error is 1/64 of the last
}

TEST_CASE("Without forces that depend on velocity, both integrators go through the same positions") {
    // Velocities at n − 1/2 kicked by a whole step are those at n − 1 kicked by two halves: the same numbers, rounded
    // elsewhere.
    const auto staggered = positions(64, end, {"method.integrator=staggered-euler"}),
               synchronous = positions(64, end, {"method.integrator=kick-drift-kick"});
    CHECK(largest_difference(staggered, synchronous) < 1e-11);
}

TEST_CASE("Viscous forces are those of half a step before in either integrator, and so the same") {
    const std::string viscosity = "method.fluid.artificial_viscosity=0.1";
    const auto staggered = positions(64, end, {"method.integrator=staggered-euler", viscosity}),
               synchronous = positions(64, end, {"method.integrator=kick-drift-kick", viscosity});
    CHECK(largest_difference(staggered, synchronous) < 1e-11);
    CHECK(largest_difference(synchronous, positions(64, end, {"method.integrator=kick-drift-kick"})) > 1e-6);
    // So what is dissipated is of first order in the step.
    const std::vector<std::string> overrides{"method.integrator=kick-drift-kick", viscosity};
    const auto exact = positions(1024, end, overrides);
    const double coarse = largest_difference(positions(64, end, overrides), exact),
                 fine = largest_difference(positions(128, end, overrides), exact);
    CAPTURE(coarse, fine, order(coarse, fine));
    CHECK(order(coarse, fine) > 0.8);
}

TEST_CASE("An adaptive step is the Courant limit with the fluid's speed added to that of sound") {
    const std::string flow = "velocity = [3.0, 0.0]";
    const std::vector<std::string> more{"method.expected_speed=3", "method.step_size=adaptive"};
    Simulation<2> rest(scene_text::load(waves::box(0.005, 0.05, ""), more)),
        flows(scene_text::load(waves::box(0.005, 0.05, flow), more));
    const double limit = flows.courant_limits()[0].dt;
    CHECK(rest.time_step() == limit);
    CHECK(flows.time_step() == Approx(limit * 30 / (30 + 3)).epsilon(1e-12));
    advance(flows, 20);
    CHECK(flows.time_step() == Approx(limit * 30 / (30 + 3)).epsilon(1e-9));  // nothing changes but by rounding
}

TEST_CASE("An adaptive step shrinks at once and grows by a tenth at the most; time is the sum of steps") {
    Simulation<2> s(
        scene_text::load("acceleration = [\"t < 0.0005 ? 20000 : 0\", \"0\"]\n" + waves::box(0.005, 0.05, ""),
                         waves::plain({"method.step_size=adaptive", "method.mach_limit=1"})));
    const double limit = s.courant_limits()[0].dt, h = s.courant_limits()[0].h;
    double before = s.time_step(), time = 0;
    bool accelerated = false;
    for (int n = 0; n < 60; ++n) {
        const double speed = std::abs(s.fluid().velocity[0][0]);
        s.step();
        const double dt = s.time_step();
        time += dt;
        CHECK(s.time() == Approx(time).epsilon(1e-13));
        if (n == 0) {
            before = dt;
            continue;
        }
        CHECK(dt <= 1.1 * before * (1 + 1e-12));
        CHECK(dt <= limit * 30 / (30 + 0.4 * speed));  // the speed that counts is half a step old, at first half
        accelerated = accelerated || dt == Approx(0.25 * std::sqrt(h / 20000)).epsilon(1e-6);
        before = dt;
    }
    CHECK(accelerated);
    // As fast as 10 m/s now, without acceleration.
    CHECK(before == Approx(limit * 30 / (30 + std::abs(s.fluid().velocity[0][0]))).epsilon(1e-6));
}

TEST_CASE("A box that is shaken in adaptive steps keeps momentum and acceleration in step") {
    const std::string integrator = GENERATE("staggered-euler", "kick-drift-kick");
    Simulation<2> s(scene_text::load("acceleration = [\"100\", \"0\"]\n" + waves::box(0.005, 0.05, ""),
                                     {"method.step_size=adaptive", "method.mach_limit=1",
                                      "method.fluid.velocity_filter=1", "method.integrator=" + integrator}));
    advance(s, 80);
    double mass = 0;
    for (std::size_t i = 0; i < s.fluid().owned; ++i) mass += s.fluid().mass[i];
    const double behind = integrator == "staggered-euler" ? 0.5 * s.time_step() : 0;
    CHECK(s.momentum()[0] == Approx(mass * 100 * (s.time() - behind)).epsilon(1e-12));
}

}  // namespace sluice::test_time_integration
