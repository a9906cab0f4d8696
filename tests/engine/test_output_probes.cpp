#include <algorithm>
#include <random>

#include "engine/geometry/moving_least_squares.hpp"
#include "engine/particles/id_index.hpp"
#include "engine/run/output/probes.hpp"
#include "tests/catch.hpp"
#include "tests/engine/test_scenes.hpp"

namespace sluice::test_output_probes {
namespace {

template <int Dim>
std::vector<Vec<Dim>> lattice(int n, double spacing) {
    std::vector<Vec<Dim>> points;
    for (int i = 0; i < (Dim == 2 ? n * n : n * n * n); ++i) {
        Vec<Dim> x;
        int rest = i;
        for (int k = 0; k < Dim; ++k, rest /= n) x[k] = spacing * (rest % n + 0.5);
        points.push_back(x);
    }
    return points;
}

/// Interpolates a field that is 2 + 3x − 5y [+ 7z].
template <int Dim>
double affine(const Vec<Dim>& x) {
    const double slope[3]{3, -5, 7};
    double f = 2;
    for (int k = 0; k < Dim; ++k) f += slope[k] * x[k];
    return f;
}

template <int Dim>
void check_affine(const std::vector<Vec<Dim>>& points, const Vec<Dim>& at, double radius) {
    const auto shares = least_squares_shares<Dim>(points, at, radius);
    REQUIRE(shares);
    double sum = 0, value = 0;
    for (const Share& share : *shares) {
        sum += share.weight;
        value += share.weight * affine(points[share.point]);
    }
    // The moment matrix has a condition of 1e3 at the corners, so that 1e-16 becomes 1e-13; one digit of margin.
    REQUIRE(sum == Approx(1).epsilon(1e-12));
    REQUIRE(value == Approx(affine(at)).epsilon(1e-12));
}

/// Values of one probe.
template <int Dim>
double value_of(const Probes<Dim>& probes, const Simulation<Dim>& simulation, const std::string& column) {
    const auto columns = probes.columns();
    const auto found = std::find(columns.begin(), columns.end(), column);
    REQUIRE(found != columns.end());
    return probes.sample(simulation)[static_cast<std::size_t>(found - columns.begin())];
}

}  // namespace

TEST_CASE("Least-squares shares reproduce affine fields inside, on the rim and half a spacing outside") {
    const double d = 0.01;
    for (const Vec<2> at : {Vec<2>{{0.043, 0.051}}, Vec<2>{{0.0, 0.05}}, Vec<2>{{0.0, 0.0}}, Vec<2>{{0.1, 0.1}}})
        check_affine<2>(lattice<2>(10, d), at, 3 * d);
    for (const Vec<3> at : {Vec<3>{{0.03, 0.031, 0.029}}, Vec<3>{{0.0, 0.03, 0.03}}, Vec<3>{{0.06, 0.06, 0.06}}})
        check_affine<3>(lattice<3>(6, d), at, 3 * d);
}

TEST_CASE("Least-squares shares reproduce affine fields on scattered points") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec<2>> points(200);
    for (auto& point : points) point = {{unit(random), unit(random)}};
    check_affine<2>(points, {{0.5, 0.5}}, 0.3);
    check_affine<2>(points, {{0.0, 0.0}}, 0.3);
}

TEST_CASE("Points on a line, or too few, give no shares") {
    const std::vector<Vec<2>> line{{{0, 0}}, {{0.25, 0.25}}, {{0.5, 0.5}}, {{0.75, 0.75}}, {{1, 1}}};
    REQUIRE_FALSE(least_squares_shares<2>(line, {{0.5, 0.5}}, 2));
    REQUIRE_FALSE(least_squares_shares<2>({{{0, 0}}, {{1, 0}}, {{0, 1}}}, {{0.3, 0.3}}, 3));
}

TEST_CASE("Columns carry names and units") {
    const Simulation<2> simulation(load_scene(test_scene("small_gate.toml")));
    const Probes<2> probes(simulation);
    REQUIRE(probes.columns() ==
            std::vector<std::string>{"tip.x [m]", "tip.y [m]", "gate_pressure.p [Pa]", "tank_pressure.p [Pa]",
                                     "level.level [m]", "level_at_back.level [m]", "energy.kinetic [J/m]",
                                     "energy.potential [J/m]", "energy.compression [J/m]", "energy.elastic [J/m]",
                                     "energy.contact [J/m]", "energy.total [J/m]", "momentum.x [kg/s]",
                                     "momentum.y [kg/s]", "force.x [N/m]", "force.y [N/m]"});
}

TEST_CASE("Probes of water at rest show its depth and hydrostatic pressure") {
    const Simulation<2> simulation(load_scene(test_scene("small_gate.toml")));
    const Probes<2> probes(simulation);
    // Water compressed under its own weight counts as m/ρ0: H (1 + g H / 2c²).
    const double depth = 0.06 * (1 + 9.81 * 0.06 / (2 * 20 * 20));
    REQUIRE(value_of(probes, simulation, "level.level [m]") == Approx(depth).epsilon(1e-9));
    // The strip around the back wall is cut in half by it, and so is the water. The outer squares are 4e-4 of a side
    // wider than the lattice, and what stands behind the wall is lost: up to 4e-4/2 of one column in three.
    REQUIRE(value_of(probes, simulation, "level_at_back.level [m]") == Approx(depth).epsilon(1e-4));
    // ρ g (0.06 − 0.03); a symmetric mean of a linear field, up to the 1e-3 that ρ varies under its own weight.
    REQUIRE(value_of(probes, simulation, "tank_pressure.p [Pa]") == Approx(1000 * 9.81 * 0.03).epsilon(2e-3));
    REQUIRE(value_of(probes, simulation, "tip.x [m]") == 0);
    REQUIRE(value_of(probes, simulation, "energy.kinetic [J/m]") == 0);
}

TEST_CASE("Water level in 3D is volume over area") {
    const Simulation<3> simulation(load_scene(test_scene("still_water_3d.toml")));
    const Probes<3> probes(simulation);
    // As in 2D: H (1 + g H / 2c²); cubes a little wider than the lattice overlap the rectangle's rim by 1e-4.
    REQUIRE(value_of(probes, simulation, "level.level [m]") == Approx(0.06 * (1 + 9.81 * 0.06 / 800)).epsilon(1e-3));
    REQUIRE(probes.columns().back() == "energy.total [J]");
}

TEST_CASE("A displacement probe follows its body") {
    Scene scene = load_scene(test_scene("small_gate.toml"));
    Simulation<2> simulation(scene);
    const Probes<2> probes(simulation);
    for (int k = 0; k < 50; ++k) simulation.step();
    // The mean displacement of the lowest row, which the probe extrapolates to the foot, half a spacing below.
    const auto& solid = simulation.solid();
    const Simulation<2> initial(scene);
    double mean = 0, count = 0;
    for (std::size_t i = 0; i < solid.owned; ++i) {
        const auto before = initial.solid().position[initial.solid_index_of_id()[solid.id[i]]];
        if (before[1] > 0.0025) continue;
        mean += solid.position[i][0] - before[0];
        ++count;
    }
    mean /= count;
    REQUIRE(mean > 0);
    // The foot moves further than the row above it by the gate's slope times d/2: a few per cent of the whole.
    REQUIRE(value_of(probes, simulation, "tip.x [m]") == Approx(mean).epsilon(0.1));
}

}  // namespace sluice::test_output_probes
