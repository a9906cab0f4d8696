// The pressure of ghosts whose walls are accelerated each in its own way, against its plain twin.
#include "kernels/passes/wall_passes.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_moving_boundary.hpp"

namespace sluice::test_moving_ghosts {

namespace {

/// Fluid, and ghosts of three walls in turn.
template <int Dim>
struct MovingWalls {
    Particles<Dim> fluid, wall;
    Array<std::uint16_t> wall_of;
    std::vector<Vec<Dim>> gravity;  ///< g − a of each wall [m/s²]

    explicit MovingWalls(Scene scene, Layout layout = Layout::shuffled)
        : fluid(make_scene<Dim>(scene, 1, layout)), wall(make_scene<Dim>(scene, 2, layout)) {
        for (double& x : wall.position.c[1]) x -= scene == Scene::crowded ? 0.03 : 0.9;
        Random random(3);
        for (int w = 0; w < 3; ++w) gravity.push_back(random.vector<Dim>(-50, 50));
        for (std::size_t i = 0; i < wall.size(); ++i) wall_of.push_back(static_cast<std::uint16_t>(i % 3));
    }
    ScalarField pressure(const NeighborList& list, Precision precision) const {
        ScalarField p(wall.size(), 777.0);  // of an earlier step
        CHECK(moving_ghost_pressure<Dim>(wall.view(), fluid.view(), list, gravity, wall_of, precision, p) ==
              list.pairs());
        return p;
    }
};

/// The largest error of the ghosts' pressure, in units of its rounding; infinite if no ghost is wet.
double worst_pressure_error(const ScalarField& pressure, const twin::Sums<2>& sums) {
    double worst = 0;
    std::size_t wet = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        const double weight = sums.value[i][0];
        const double expected = weight > 0 ? std::max(sums.value[i][1] / weight, 0.0) : 0;
        // A ghost whose only partners stand at the very edge of the support has W ≈ 0, (2−q)³ of a rounded q.
        if (weight > 0 && weight < 1e-4) continue;
        wet += weight > 0;
        // Σ V p W and g·Σ m x W are summed apart, each to its own magnitude: ρ g d is up to 1e4 Pa, as p is.
        const double scale = weight > 0 ? sums.magnitude[i][1] / weight + 1e4 : 1;
        worst = std::max(worst, relative_error(pressure[i], expected, scale));
    }
    return wet > 0 ? worst : std::numeric_limits<double>::infinity();
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the pressure of moving ghosts equals its twin", "[wall]", ((int Dim), Dim), 2, 3) {
    for (const Scene scene : scenes)
        for (const Layout layout : layouts) {
            CAPTURE(static_cast<int>(scene), layout == Layout::sorted);
            const MovingWalls<Dim> s(scene, layout);
            const auto sums = twin::moving_ghost_pressure_sums<Dim>(s.wall, s.fluid, s.gravity, s.wall_of);
            const NeighborList list = list_of(s.wall, s.fluid);
            in_all_variants([&](Precision precision) {
                // A quotient of sums, of which some are of the edge's kind.
                CHECK(worst_pressure_error(s.pressure(list, precision), sums) < 10 * twin_tolerance(precision));
            });
        }
}

TEMPLATE_TEST_CASE_SIG("ghosts of walls that are not accelerated are those of fixed walls", "[wall]", ((int Dim), Dim),
                       2, 3) {
    MovingWalls<Dim> s(Scene::unequal);
    Vec<Dim> g;
    g[1] = -9.81;
    s.gravity.assign(3, g);
    const NeighborList list = list_of(s.wall, s.fluid);
    in_all_variants([&](Precision precision) {
        ScalarField fixed(s.wall.size(), 0.0);
        fixed_ghost_pressure<Dim>(s.wall.view(), s.fluid.view(), list, g, precision, fixed);
        const ScalarField moving = s.pressure(list, precision);
        double worst = 0;
        for (std::size_t i = 0; i < fixed.size(); ++i)
            worst = std::max(worst, relative_error(moving[i], fixed[i], 3e4));  // the fluid's pressures
        CHECK(worst < 10 * twin_tolerance(precision));
    });
}

TEMPLATE_TEST_CASE_SIG("moving ghosts have the same bits for any number of threads", "[wall]", ((int Dim), Dim), 2, 3) {
    const MovingWalls<Dim> s(Scene::unequal);
    const NeighborList list = list_of(s.wall, s.fluid);
    in_all_variants([&](Precision precision) {
        std::vector<ScalarField> pressures;
        for (const int threads : {1, 2, 4}) {
            const ThreadScope scope(threads);
            pressures.push_back(s.pressure(list, precision));
        }
        CHECK((pressures[1] == pressures[0]));
        CHECK((pressures[2] == pressures[0]));
    });
}

}  // namespace sluice::test_moving_ghosts
