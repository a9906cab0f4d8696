// The passes of fixed ghosts against their plain twins.
#include "kernels/wall_passes.hpp"

#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_boundary.hpp"

using namespace sluice;

namespace {

/// Fluid and ghosts side by side and partly through each other, both in a random state.
template <int Dim>
struct WallScene {
    Particles<Dim> fluid, wall;
    Vec<Dim> gravity;

    explicit WallScene(Scene scene) : fluid(make_scene<Dim>(scene, 1)), wall(make_scene<Dim>(scene, 2)) {
        for (double& x : wall.position.c[1]) x -= scene == Scene::crowded ? 0.03 : 0.9;
        gravity[0] = 3;
        gravity[1] = -9.81;
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("fixed_ghost_pressure equals its twin", "[wall]", ((int Dim, class Real), Dim, Real),
                       (2, double), (2, float), (3, double), (3, float)) {
    for (const Scene scene : scenes) {
        const WallScene<Dim> s(scene);
        const auto sums = twin::ghost_pressure_sums<Dim>(s.wall, s.fluid, s.gravity);
        for (const int group_size : {1, 8}) {
            ScalarField pressure(s.wall.size(), 777.0);  // of an earlier step
            fixed_ghost_pressure<Dim, Real>(s.wall.view(), s.fluid.view(), list_of(s.wall, s.fluid, group_size),
                                            s.gravity, pressure);
            double worst = 0;
            std::size_t wet = 0;
            for (std::size_t i = 0; i < pressure.size(); ++i) {
                const double weight = sums.value[i][0];
                const double expected = weight > 0 ? std::max(sums.value[i][1] / weight, 0.0) : 0;
                const double scale = weight > 0 ? sums.magnitude[i][1] / weight : 1;
                wet += weight > 0;
                // A ghost whose only partners stand at the very edge of the support has W ≈ 0, (2−q)³ of a rounded q.
                if (weight * std::pow(s.wall.h[i], Dim) < 1e-6) continue;
                worst = std::max(worst, relative_error(pressure[i], expected, scale));
            }
            CAPTURE(static_cast<int>(scene), group_size);
            CHECK(wet > 0);
            CHECK(worst < 10 * twin_tolerance<Real>);  // a quotient of two sums, of which some are of the edge's kind
        }
    }
}

TEMPLATE_TEST_CASE_SIG("fixed_ghost_force and fixed_ghost_continuity equal their twins", "[wall]",
                       ((int Dim, class Real), Dim, Real), (2, double), (2, float), (3, double), (3, float)) {
    for (const Scene scene : scenes) {
        const WallScene<Dim> s(scene);
        const auto force = twin::ghost_force<Dim>(s.fluid, s.wall);
        const auto rate = twin::ghost_continuity<Dim>(s.fluid, s.wall);
        for (const int group_size : {1, 8}) {
            const NeighborList list = list_of(s.fluid, s.wall, group_size);
            auto a = zeros<Dim>(s.fluid.size());
            ScalarField drho(s.fluid.size(), 0.0);
            fixed_ghost_force<Dim, Real>(s.fluid.view(), s.wall.view(), list, a);
            fixed_ghost_continuity<Dim, Real>(s.fluid.view(), s.wall.view(), list, drho);
            CAPTURE(static_cast<int>(scene), group_size);
            CHECK(worst_error(a, force) < twin_tolerance<Real>);
            CHECK(worst_error(drho, rate) < twin_tolerance<Real>);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("ghosts without fluid near have no pressure", "[wall]", ((int Dim), Dim), 2, 3) {
    auto wall = make_scene<Dim>(Scene::jittered);
    Particles<Dim> fluid = make_scene<Dim>(Scene::jittered);
    for (double& x : fluid.position.c[0]) x += 50;
    ScalarField pressure(wall.size(), 777.0);
    fixed_ghost_pressure<Dim, double>(wall.view(), fluid.view(), list_of(wall, fluid), {}, pressure);
    CHECK((pressure == ScalarField(wall.size(), 0.0)));
}

TEMPLATE_TEST_CASE_SIG("wall passes have the same bits for any number of threads", "[wall]", ((int Dim), Dim), 2, 3) {
    const WallScene<Dim> s(Scene::unequal);
    const NeighborList fluid_wall = list_of(s.fluid, s.wall), wall_fluid = list_of(s.wall, s.fluid);
    std::vector<ScalarField> pressures, rates;
    std::vector<VectorField<Dim>> forces;
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        auto a = zeros<Dim>(s.fluid.size());
        ScalarField p(s.wall.size(), 0.0), rate(s.fluid.size(), 0.0);
        fixed_ghost_pressure<Dim, float>(s.wall.view(), s.fluid.view(), wall_fluid, s.gravity, p);
        fixed_ghost_force<Dim, float>(s.fluid.view(), s.wall.view(), fluid_wall, a);
        fixed_ghost_continuity<Dim, float>(s.fluid.view(), s.wall.view(), fluid_wall, rate);
        pressures.push_back(p);
        rates.push_back(rate);
        forces.push_back(a);
    }
    for (const std::size_t t : {1, 2}) {
        CHECK((pressures[t] == pressures[0]));
        CHECK((rates[t] == rates[0]));
        CHECK(same_bits(forces[t], forces[0]));
    }
}
