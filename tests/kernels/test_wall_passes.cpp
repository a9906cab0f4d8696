// The passes of fixed ghosts against their plain twins.
#include "kernels/passes/wall_passes.hpp"

#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_wall.hpp"

namespace sluice::test_wall_passes {

namespace {

/// Fluid and ghosts side by side and partly through each other, both in a random state.
template <int Dim>
struct WallScene {
    Particles<Dim> fluid, wall;
    Vec<Dim> gravity;

    explicit WallScene(Scene scene, Layout layout = Layout::shuffled)
        : fluid(make_scene<Dim>(scene, 1, layout)), wall(make_scene<Dim>(scene, 2, layout)) {
        for (double& x : wall.position.c[1]) x -= scene == Scene::crowded ? 0.03 : 0.9;
        gravity[0] = 3;
        gravity[1] = -9.81;
    }
};

/// The largest error of the ghosts' pressure, in units of its rounding; infinite if no ghost is wet.
double worst_pressure_error(const ScalarField& pressure, const twin::Sums<2>& sums) {
    double worst = 0;
    std::size_t wet = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        const double weight = sums.value[i][0];
        const double expected = weight > 0 ? std::max(sums.value[i][1] / weight, 0.0) : 0;
        const double scale = weight > 0 ? sums.magnitude[i][1] / weight : 1;
        // A ghost whose only partners stand at the very edge of the support has W ≈ 0, (2−q)³ of a rounded q.
        if (weight > 0 && weight < 1e-4) continue;
        wet += weight > 0;
        worst = std::max(worst, relative_error(pressure[i], expected, scale));
    }
    return wet > 0 ? worst : std::numeric_limits<double>::infinity();
}

/// run(scene) on every scene in both layouts.
template <int Dim, class Run>
void in_all_wall_scenes(Run&& run) {
    for (const Scene scene : scenes)
        for (const Layout layout : layouts) {
            CAPTURE(static_cast<int>(scene), layout == Layout::sorted);
            run(WallScene<Dim>(scene, layout));
        }
}

/// All three passes against their twins.
template <int Dim>
void check_all_passes(const WallScene<Dim>& s) {
    const auto sums = twin::ghost_pressure_sums<Dim>(s.wall, s.fluid, s.gravity);
    const auto force = twin::ghost_force<Dim>(s.fluid, s.wall);
    const auto rate = twin::ghost_continuity<Dim>(s.fluid, s.wall);
    const NeighborList fluid_wall = list_of(s.fluid, s.wall), wall_fluid = list_of(s.wall, s.fluid);
    in_all_variants([&](Precision precision) {
        ScalarField pressure(s.wall.size(), 777.0), drho(s.fluid.size(), 0.0);  // pressure of an earlier step
        auto a = zeros<Dim>(s.fluid.size());
        CHECK(fixed_ghost_pressure<Dim>(s.wall.view(), s.fluid.view(), wall_fluid, s.gravity, precision, pressure) ==
              wall_fluid.pairs());
        fixed_ghost_force<Dim>(s.fluid.view(), s.wall.view(), fluid_wall, precision, a);
        fixed_ghost_continuity<Dim>(s.fluid.view(), s.wall.view(), fluid_wall, precision, drho);
        // A quotient of two sums, of which some are of the edge's kind.
        CHECK(worst_pressure_error(pressure, sums) < 10 * twin_tolerance(precision));
        CHECK(worst_error(a, force) < twin_tolerance(precision));
        CHECK(worst_error(drho, rate) < twin_tolerance(precision));
    });
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the passes of fixed ghosts equal their twins", "[wall]", ((int Dim), Dim), 2, 3) {
    in_all_wall_scenes<Dim>([](const auto& s) { check_all_passes(s); });
}

TEMPLATE_TEST_CASE_SIG("the passes of fixed ghosts far from the origin", "[wall]", ((int Dim), Dim), 2, 3) {
    WallScene<Dim> s(Scene::unequal);
    for (auto* set : {&s.fluid, &s.wall})
        for (auto& column : set->position.c)
            for (double& x : column) x -= 1e4;  // [m]; a float's grid there is 1e-3 m, a spacing is 0.1 m
    check_all_passes(s);
}

TEMPLATE_TEST_CASE_SIG("the passes of fixed ghosts at any scale", "[wall]", ((int Dim), Dim), 2, 3) {
    for (const double scale : scales) {
        WallScene<Dim> s(Scene::odd);
        rescale(s.fluid, scale);
        rescale(s.wall, scale);
        CAPTURE(scale);
        check_all_passes(s);
    }
}

TEMPLATE_TEST_CASE_SIG("ghosts without fluid near have no pressure", "[wall]", ((int Dim), Dim), 2, 3) {
    const auto wall = make_scene<Dim>(Scene::jittered);
    auto fluid = make_scene<Dim>(Scene::jittered);
    for (double& x : fluid.position.c[0]) x += 50;
    const NeighborList list = list_of(wall, fluid);
    in_all_variants([&](Precision precision) {
        ScalarField pressure(wall.size(), 777.0);
        fixed_ghost_pressure<Dim>(wall.view(), fluid.view(), list, {}, precision, pressure);
        CHECK((pressure == ScalarField(wall.size(), 0.0)));
    });
}

TEMPLATE_TEST_CASE_SIG("wall passes have the same bits for any number of threads", "[wall]", ((int Dim), Dim), 2, 3) {
    const WallScene<Dim> s(Scene::unequal);
    const NeighborList fluid_wall = list_of(s.fluid, s.wall), wall_fluid = list_of(s.wall, s.fluid);
    in_all_variants([&](Precision precision) {
        std::vector<ScalarField> pressures, rates;
        std::vector<VectorField<Dim>> forces;
        for (const int threads : {1, 2, 4}) {
            const ThreadScope scope(threads);
            auto a = zeros<Dim>(s.fluid.size());
            ScalarField p(s.wall.size(), 0.0), rate(s.fluid.size(), 0.0);
            fixed_ghost_pressure<Dim>(s.wall.view(), s.fluid.view(), wall_fluid, s.gravity, precision, p);
            fixed_ghost_force<Dim>(s.fluid.view(), s.wall.view(), fluid_wall, precision, a);
            fixed_ghost_continuity<Dim>(s.fluid.view(), s.wall.view(), fluid_wall, precision, rate);
            pressures.push_back(p);
            rates.push_back(rate);
            forces.push_back(a);
        }
        for (const std::size_t t : {1, 2}) {
            CHECK((pressures[t] == pressures[0]));
            CHECK((rates[t] == rates[0]));
            CHECK(same_bits(forces[t], forces[0]));
        }
    });
}

}  // namespace sluice::test_wall_passes
