// Viscous flow between two plates in 3D, periodic along both: plates that do not let it slip, of every kind that there
// is, and mirror walls, along which it slips.
#include <fmt/format.h>

#include "engine/scene/rules/effects.hpp"
#include "tests/catch.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::test_shear_flow_3d {
namespace {

constexpr double gap = 0.02, spacing = 0.0025, viscosity = 0.02;  // [m, m, m²/s]

/// No other dissipation than the fluid's viscosity; velocities at the time of the positions.
const std::vector<std::string> method{"method.preset=paper",
                                      "method.fluid.velocity_filter=1",
                                      "method.integrator=kick-drift-kick",
                                      "method.coupling=moving-boundary",
                                      "materials.rubber.model=neo-hookean",
                                      "materials.water.viscosity=20.0"};

/// Water between y = 0 and the gap, five spacings, a little more than a support, along x and z.
std::string channel(const std::string& head, const std::string& plates) {
    return head + "dimension = 3\n" + preamble(spacing) +
           "[domain]\nperiodic = { x = [0.0, 0.0125], z = [0.0, 0.0125] }\n" +
           water_box("0.0, 0.0, 0.0", "0.0125, 0.02, 0.0125") + plates;
}

constexpr const char* lower = "{ box = { min = [0.0, -0.01, 0.0], max = [0.0125, 0.0, 0.0125] } }";
constexpr const char* upper = "{ box = { min = [0.0, 0.02, 0.0], max = [0.0125, 0.03, 0.0125] } }";

/// `motion`: of the upper one.
std::string fixed_plates(const std::string& motion = "") {
    const auto plate = [](const char* name, const char* shape) {
        return fmt::format("[walls.{}]\nkind = \"fixed\"\nshape = {}\ncondition = \"no-slip\"\n", name, shape);
    };
    return plate("lower", lower) + plate("upper", upper) + motion;
}

/// Of rubber, clamped altogether.
std::string rubber_plates() {
    const auto plate = [](const char* name, const char* shape) {
        return fmt::format("[bodies.{0}]\nmaterial = \"rubber\"\nshape = {1}\nclamp = {1}\n", name, shape);
    };
    return plate("lower", lower) + plate("upper", upper);
}

constexpr const char* mirror_plates = R"toml(
[walls.lower]
kind = "mirror"
point = [0.0, 0.0, 0.0]
normal = [0.0, 1.0, 0.0]
[walls.upper]
kind = "mirror"
point = [0.0, 0.02, 0.0]
normal = [0.0, -1.0, 0.0]
)toml";

/// Half of gap²/ν: the slowest part of the transient, e^(−π² ν t/gap²), has fallen to 0.7 %.
void settle(Simulation<3>& s) {
    while (s.time() < 0.5 * gap * gap / viscosity) s.step();
}

/// The largest distance of any particle's velocity from (profile(y), 0, 0). [m/s]
template <class Profile>
double distance_from(const ParticleSet<3>& fluid, Profile&& profile) {
    double largest = 0;
    for (std::size_t i = 0; i < fluid.owned; ++i)
        largest = std::max(largest, norm(fluid.velocity[i] - Vec<3>{{profile(fluid.position[i][1]), 0, 0}}));
    return largest;
}

}  // namespace

TEST_CASE("Couette flow in 3D: the fluid sticks to a fixed wall and to one that moves", "[3d]") {
    const double speed = 0.1;
    Simulation<3> s(
        scene_text::load(channel("", fixed_plates("motion = { displacement = [\"0.1*t\", \"0\", \"0\"] }\n")), method));
    REQUIRE(s.effects().has(Effect::no_slip_wall));
    REQUIRE(s.effects().has(Effect::moving_wall));
    settle(s);
    const double error = distance_from(s.fluid(), [&](double y) { return speed * y / gap; });
    CAPTURE(error / speed);
    CHECK(error < 0.006 * speed);  // the transient's rest, 2/π of 0.7 %; a straight profile is exact otherwise
}

TEST_CASE("Poiseuille flow in 3D, driven by an acceleration, between fixed walls and between clamped solids", "[3d]") {
    const bool solids = GENERATE(false, true);
    CAPTURE(solids);
    const double drive = 40, peak = drive * gap * gap / (8 * viscosity);  // 0.1 m/s
    Simulation<3> s(scene_text::load(
        channel("acceleration = [\"40\", \"0\", \"0\"]\n", solids ? rubber_plates() : fixed_plates()), method));
    REQUIRE(s.effects().has(Effect::driven_acceleration));
    REQUIRE(s.effects().has(solids ? Effect::no_slip_solid : Effect::no_slip_wall));
    settle(s);
    const double error = distance_from(s.fluid(), [&](double y) { return 4 * peak * y * (gap - y) / (gap * gap); });
    CAPTURE(error / peak);
    // 0.7 % is the transient's. A ghost's velocity continues a straight profile, and a curved one is off by (h/gap)²:
    // 3.0 % at fixed walls and 1.9 % at solids with eight spacings across, 1.0 and 1.2 % with sixteen.
    CHECK(error < 0.035 * peak);
}

TEST_CASE("Between mirror walls a viscous fluid slips in 3D", "[3d]") {
    Simulation<3> s(scene_text::load(channel("acceleration = [\"40\", \"0\", \"-10\"]\n", mirror_plates), method));
    advance(s, 50);
    for (std::size_t i = 0; i < s.fluid().owned; ++i) {
        // The lattice moves as one: what is left is rounding.
        const Vec<3> expected{{40 * s.time(), 0, -10 * s.time()}};
        REQUIRE(norm(s.fluid().velocity[i] - expected) < 1e-9 * norm(expected));
    }
}

}  // namespace sluice::test_shear_flow_3d
