// Motion that the scene prescribes: of everything by an acceleration, of walls by formula or table.
#include "engine/scene/rules/effects.hpp"
#include "tests/catch.hpp"
#include "tests/engine/wave_scenes.hpp"

namespace sluice::test_driven_motion {
namespace {

/// Water against a piston of fixed ghosts on its left; free on its right, periodic across.
std::string piston(const std::string& motion) {
    return preamble(0.0025) + R"toml(
[domain]
periodic = { y = [0.0, 0.03] }
[bodies.water]
material = "water"
shape = { box = { min = [0.0, 0.0], max = [0.1, 0.03] } }
[walls.piston]
kind = "fixed"
shape = { box = { min = [-0.01, 0.0], max = [0.0, 0.03] } }
)toml" + (motion.empty() ? "" : "motion = " + motion + "\n");
}

double total_mass(const ParticleSet<2>& fluid) {
    double m = 0;
    for (std::size_t i = 0; i < fluid.owned; ++i) m += fluid.mass[i];
    return m;
}

}  // namespace

TEST_CASE("A shaken box gives its fluid the acceleration's integral as momentum") {
    Simulation<2> s(
        scene_text::load("acceleration = [\"3*sin(100*t)\", \"0.5\"]\n" + waves::box(0.005, 0.05, ""), waves::plain()));
    const double mass = total_mass(s.fluid()), dt = s.time_step();
    double kicks = 0;
    const int steps = 150;
    for (int n = 0; n < steps; ++n) kicks += 0.5 * dt * (3 * std::sin(100 * n * dt) + 3 * std::sin(100 * (n + 1) * dt));
    advance(s, steps);
    const double t = s.time();
    CHECK(s.momentum()[0] == Approx(mass * kicks).epsilon(1e-12));
    CHECK(s.momentum()[1] == Approx(mass * 0.5 * t).epsilon(1e-12));
    // (100 Δt)²/12 of the trapezoidal rule
    CHECK(s.momentum()[0] == Approx(mass * 0.03 * (1 - std::cos(100 * t))).epsilon(1e-4));
}

TEST_CASE("Fluid and solid feel the same driven acceleration") {
    const std::string model = GENERATE("hypoelastic", "st-venant-kirchhoff");
    Simulation<2> s(scene_text::load("acceleration = [\"2.0\", \"0\"]\n" + preamble(0.0025) + R"toml(
[bodies.block]
material = "rubber"
shape = { box = { min = [0.0, 0.0], max = [0.02, 0.02] } }
)toml",
                                     {"materials.rubber.model=" + model}));
    advance(s, 100);
    double mass = 0;
    for (std::size_t i = 0; i < s.solid().owned; ++i) mass += s.solid().mass[i];
    const double behind = model == "hypoelastic" ? 0.5 * s.time_step() : 0;  // its velocities stand at n − 1/2
    CHECK(s.momentum()[0] == Approx(mass * 2 * (s.time() - behind)).epsilon(1e-12));
}

TEST_CASE("A piston by table and by the same linear formula gives the same bits") {
    Simulation<2> formula(scene_text::load(piston("{ displacement = [\"0.2*t\", \"0\"] }"))),
        table(scene_text::load(piston("{ table = [[0.0, 0.0, 0.0], [1.0, 0.2, 0.0]] }")));
    REQUIRE(formula.effects().has(Effect::moving_wall));
    advance(formula, 50);
    advance(table, 50);
    CHECK(formula.wall().position.c == table.wall().position.c);
    CHECK(formula.fluid().position.c == table.fluid().position.c);
    CHECK(formula.fluid().velocity.c == table.fluid().velocity.c);
}

TEST_CASE("A piston gives the fluid the momentum of the sound wave that it sends out") {
    const double speed = 0.2;
    Simulation<2> s(scene_text::load(piston("{ displacement = [\"0.2*t\", \"0\"] }"), waves::plain()));
    waves::advance_to(s, 0.8 * 0.1 / waves::sound_speed);  // the wave has not yet reached the free end
    // Behind the front the fluid moves as the piston does: momentum ρ c V t per area, its kinetic energy half of what
    // the piston has done, p V t with p = ρ c V.
    const double expected = 1000 * waves::sound_speed * speed * s.time() * 0.03;
    CAPTURE(s.momentum()[0] / expected);
    CHECK(s.momentum()[0] == Approx(expected).epsilon(0.1));  // the first step's share of 24, and the front's ringing
    CHECK(std::abs(s.momentum()[1]) < 1e-9 * expected);
    CHECK(waves::energy(s) == Approx(expected * speed).epsilon(0.15));
    for (std::size_t i = 0; i < s.wall().owned; ++i) CHECK(s.wall().position[i][0] > -0.01 + speed * s.time());
    for (std::size_t i = 0; i < s.fluid().owned; ++i) CHECK(s.fluid().position[i][0] > speed * s.time());
}

TEST_CASE("A wall that does not move in the end is a wall that never moved, to rounding") {
    // The rates of a moving wall are those of a moving boundary: another pass, the same sum.
    Simulation<2> rests(scene_text::load("gravity = [-9.81, 0.0]\n" + piston(""))),
        moves(scene_text::load("gravity = [-9.81, 0.0]\n" + piston("{ displacement = [\"0*t\", \"0\"] }")));
    REQUIRE(moves.effects().has(Effect::moving_wall));
    advance(rests, 60);
    advance(moves, 60);
    CHECK(moves.momentum()[0] == Approx(rests.momentum()[0]).epsilon(1e-9));
}

TEST_CASE("A table's wall rests before its first row and after its last") {
    Simulation<2> s(scene_text::load(piston("{ table = [[0.0005, 0.0, 0.0], [0.001, 0.0002, 0.0001]] }")));
    const auto& wall = s.wall();
    advance(s, 3);  // 0.3 ms
    for (std::size_t i = 0; i < wall.owned; ++i) CHECK(wall.position[i] == wall.initial_position[i]);
    advance(s, 10);
    for (std::size_t i = 0; i < s.wall().owned; ++i) {
        const Vec<2> moved = s.wall().position[i] - s.wall().initial_position[i];
        CHECK(moved[0] == Approx(0.0002).epsilon(1e-9));
        CHECK(moved[1] == Approx(0.0001).epsilon(1e-9));
        CHECK(s.wall().velocity[i] == Vec<2>{});
    }
}

TEST_CASE("Motions that cannot be are refused with file, line and key") {
    const auto error = [](const std::string& motion) {
        return scene_text::error_of([&] { Simulation<2>{scene_text::load(piston(motion))}; });
    };
    const std::string without = piston("");
    const auto line = std::to_string(std::count(without.begin(), without.end(), '\n') + 1);
    CHECK(error("{ displacement = [\"0.1 + t\", \"0\"] }") ==
          line +
              ": walls.piston.motion: found a displacement at t = 0, expected none: the shape states where the wall "
              "starts");
    CHECK(error("{ table = [[0.0, 0.1, 0.0], [1.0, 0.2, 0.0]] }").starts_with(line + ": walls.piston.motion: found a"));
    CHECK(error("{ table = [[0.0, 0.0, 0.0], [0.0, 0.2, 0.0]] }").find("expected rising times") != std::string::npos);
    CHECK(error("{ table = [[0.0, 0.0, 0.0]] }").find("expected two or more") != std::string::npos);
    CHECK(error("{ table = [[0.0, 0.0]] }").find("rows of 3 numbers") != std::string::npos);
    CHECK(error("{ displacement = [\"x\", \"0\"] }").starts_with(line + ": walls.piston.motion.displacement[0]: "));
    CHECK(error("{ }").find("found neither displacement nor table") != std::string::npos);
    CHECK(error("{ displacement = [\"0\", \"0\"], table = [] }").find("expected one of the two") != std::string::npos);
}

}  // namespace sluice::test_driven_motion
