// A periodic box: what leaves it on one side comes back in on the other, and nobody notices.
#include <set>

#include "tests/catch.hpp"
#include "tests/engine/wave_scenes.hpp"

namespace sluice::test_periodic_box {
namespace {

constexpr double side = 0.03, spacing = 0.0025;

std::string flowing(const std::string& velocity) {
    return preamble(spacing) + fmt::format(R"toml(
[domain]
periodic = {{ x = [0.0, {0}], y = [0.0, {0}] }}
[bodies.water]
material = "water"
shape = {{ box = {{ min = [0.0, 0.0], max = [{0}, {0}] }} }}
velocity = {1}
)toml",
                                           side, velocity);
}

/// x brought into the box.
Vec<2> wrapped(Vec<2> x) {
    for (int k = 0; k < 2; ++k) x[k] -= side * std::floor(x[k] / side);
    return x;
}

/// The shortest way from one point of the box to another.
double distance(const Vec<2>& a, const Vec<2>& b) {
    Vec<2> x = a - b;
    for (int k = 0; k < 2; ++k) x[k] -= side * std::round(x[k] / side);
    return norm(x);
}

}  // namespace

TEST_CASE("A lattice that flows through a periodic box many times stays a lattice and keeps its momentum") {
    const Vec<2> velocity{{2.0, -1.3}};
    Simulation<2> s(scene_text::load(flowing("[2.0, -1.3]"), {"method.expected_speed=3", "method.step_size=fixed"}));
    const std::size_t count = s.fluid().owned;
    std::vector<Vec<2>> start(count);
    for (std::size_t i = 0; i < count; ++i) start[s.fluid().id[i]] = s.fluid().position[i];
    const Vec<2> momentum = s.momentum();
    waves::advance_to(s, 5 * side / 2.0);
    REQUIRE(s.work().neighbour_builds > 5);
    REQUIRE(s.fluid().owned == count);
    std::set<std::uint64_t> ids;
    for (std::size_t i = 0; i < count; ++i) {
        ids.insert(s.fluid().id[i]);
        // Positions are rounded at each step, 700 of them to 1e-17 m; what differs in pressure pushes at 30 m/s.
        REQUIRE(distance(s.fluid().position[i], start[s.fluid().id[i]] + s.time() * velocity) < 1e-11);
        REQUIRE(norm(s.fluid().velocity[i] - velocity) < 1e-9);
        REQUIRE(std::abs(s.fluid().pressure[i]) < 1e-4);  // ρ c0² = 1e6 Pa, in which the density's rounding counts
    }
    REQUIRE(ids.size() == count);
    REQUIRE(norm(s.momentum() - momentum) < 1e-12 * norm(momentum));
}

TEST_CASE("Particles stay within a skin of a periodic box") {
    Simulation<2> s(scene_text::load(flowing("[2.0, -1.3]"), {"method.expected_speed=3"}));
    for (int n = 0; n < 300; ++n) {
        s.step();
        for (std::size_t i = 0; i < s.fluid().owned; ++i) {
            const Vec<2> x = s.fluid().position[i];
            // Lists are built anew, and particles brought back, before any has gone half a skin of 0.8 h.
            REQUIRE(norm(wrapped(x) - x) < side * 1.5);
            for (int k = 0; k < 2; ++k) REQUIRE((x[k] > -1.2 * spacing && x[k] < side + 1.2 * spacing));
        }
    }
}

TEST_CASE("What happens at a box's side is what happens in its middle") {
    // The same eddy in the middle and across the corner; formulas are periodic.
    const double k = 2 * std::numbers::pi / side;
    const auto run = [&](double shift) {
        const std::string velocity = fmt::format("[\"0.3*sin({0}*(y-{1}))\", \"0.2*sin({0}*(x-{1}))\"]", k, shift);
        return Simulation<2>(scene_text::load(flowing(velocity), {"method.fluid.velocity_filter=1"}));
    };
    Simulation<2> middle = run(0), corner = run(side / 2);
    for (Simulation<2>* s : {&middle, &corner}) advance(*s, 100);
    // Sums differ in their order only; 100 steps of a fluid that is not yet chaotic.
    CHECK(middle.energy().kinetic == Approx(corner.energy().kinetic).epsilon(1e-10));
    CHECK(middle.energy().compression == Approx(corner.energy().compression).epsilon(1e-6));
    CHECK(norm(middle.momentum()) < 1e-12);
    CHECK(norm(corner.momentum()) < 1e-12);
}

TEST_CASE("A periodic box in three dimensions keeps a flowing lattice") {
    Simulation<3> s(scene_text::load("dimension = 3\n" + preamble(0.005) + R"toml(
[domain]
periodic = { x = [0.0, 0.04], y = [0.0, 0.04], z = [0.0, 0.04] }
[bodies.water]
material = "water"
shape = { box = { min = [0.0, 0.0, 0.0], max = [0.04, 0.04, 0.04] } }
velocity = [1.0, 0.5, -0.7]
)toml"));
    const Vec<3> momentum = s.momentum();
    for (int n = 0; n < 200; ++n) s.step();
    REQUIRE(s.time() > 0.04);  // once through and more
    for (std::size_t i = 0; i < s.fluid().owned; ++i) REQUIRE(std::abs(s.fluid().pressure[i]) < 1e-4);
    REQUIRE(norm(s.momentum() - momentum) < 1e-12 * norm(momentum));
}

TEST_CASE("Fluid outside a periodic box, and boxes too short for a support, are refused") {
    const auto error = [](const std::string& sides) {
        return scene_text::error_of([&] {
            Simulation<2>{scene_text::load(preamble(0.0025) + "[domain]\nperiodic = { x = " + sides + R"toml( }
[bodies.water]
material = "water"
shape = { box = { min = [0.0, 0.0], max = [0.03, 0.03] } }
)toml")};
        });
    };
    CHECK(error("[0.0, 0.03]").empty());
    CHECK(error("[0.0, 0.025]").find("bodies.water.shape: found a particle at (") != std::string::npos);
    CHECK(error("[0.0, 0.025]").find("expected all of the fluid inside domain.periodic.x") != std::string::npos);
    // 3 h = 4.5 d
    CHECK(error("[0.0, 0.01]").find("domain.periodic.x: found a length of 0.01 m, expected 0.01125 m or more") !=
          std::string::npos);
}

}  // namespace sluice::test_periodic_box
