// Walls of fixed ghosts where the answer is known: uniform and hydrostatic pressure on flat layers.
#include "kernels/passes/fluid_passes.hpp"
#include "kernels/passes/wall_passes.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"

namespace sluice::test_fixed_ghosts {

namespace {

constexpr double spacing = 0.1;

/// Fluid above y = 0, ghosts below it, one lattice through both.
template <int Dim>
struct FlatWall {
    Particles<Dim> fluid, wall;
    NeighborList wall_fluid, fluid_wall;

    explicit FlatWall(double h_over_d) {
        auto above = cube<Dim>(5, spacing, h_over_d);
        above.lo.fill(-5);
        auto below = above;
        above.lo[1] = 0;
        above.hi[1] = 9;
        below.lo[1] = -4;
        below.hi[1] = 0;
        fluid = lattice(above);
        wall = lattice(below);
        wall_fluid = list_of(wall, fluid);
        fluid_wall = list_of(fluid, wall);
    }
    void take_pressure(const Vec<Dim>& gravity) {
        fluid.derive();
        fixed_ghost_pressure<Dim>(wall.view(), fluid.view(), wall_fluid, gravity, Precision::full, wall.pressure);
    }
    VectorField<Dim> acceleration() {
        auto a = zeros<Dim>(fluid.size());
        fluid_momentum<Dim>(fluid.view(), list_of(fluid), {}, Precision::full, a);
        fixed_ghost_force<Dim>(fluid.view(), wall.view(), fluid_wall, Precision::full, a);
        return a;
    }
    /// Full support in fluid and wall together.
    bool deep(const Vec<Dim>& x) const {
        const double reach = 2 * fluid.h[0];
        bool inside = x[1] < 9 * spacing - reach && x[1] > -4 * spacing + reach;
        for (int k = 0; k < Dim; ++k) inside = inside && (k == 1 || std::abs(x[k]) < 5 * spacing - reach);
        return inside;
    }
};

template <int Dim>
Vec<Dim> downwards(double g) {
    Vec<Dim> v;
    v[1] = -g;
    return v;
}

/// Ghosts with fluid in their support.
template <int Dim>
bool wet(const FlatWall<Dim>& s, std::size_t i) {
    return s.wall.position[i][1] + 2 * s.wall.h[i] > 0.5 * spacing * (1 + 1e-9);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("ghosts take a uniform pressure as it is", "[fixed_ghosts]", ((int Dim), Dim), 2, 3) {
    for (const double h_over_d : {1.2, 1.5, 2.0}) {
        FlatWall<Dim> s(h_over_d);
        std::fill(s.fluid.pressure.begin(), s.fluid.pressure.end(), 1400.0);
        s.take_pressure({});
        std::size_t layers = 0;
        for (std::size_t i = 0; i < s.wall.size(); ++i) {
            if (!wet(s, i)) continue;
            ++layers;
            REQUIRE(s.wall.pressure[i] == Approx(1400).epsilon(1e-14));  // a mean of equal numbers
        }
        CHECK(layers > 0);
    }
}

TEMPLATE_TEST_CASE_SIG("a uniform pressure does not move the fluid at a wall", "[fixed_ghosts]", ((int Dim), Dim), 2,
                       3) {
    for (const double h_over_d : {1.2, 1.5, 1.7}) {
        FlatWall<Dim> s(h_over_d);
        std::fill(s.fluid.pressure.begin(), s.fluid.pressure.end(), 1400.0);
        s.take_pressure({});
        const auto a = s.acceleration();
        std::size_t checked = 0;
        double worst = 0;
        for (std::size_t i = 0; i < s.fluid.size(); ++i) {
            if (!s.deep(s.fluid.position[i])) continue;
            ++checked;
            worst = std::max(worst, norm(a[i]));
        }
        CAPTURE(h_over_d);
        CHECK(checked > 0);
        CHECK(worst < 1e-11);  // 2p/(ρ d) = 28 m/s² on either side cancel
    }
}

TEMPLATE_TEST_CASE_SIG("ghosts continue a hydrostatic pressure exactly", "[fixed_ghosts]", ((int Dim), Dim), 2, 3) {
    const double g = 9.81;
    for (const double h_over_d : {1.2, 1.5, 1.7}) {
        FlatWall<Dim> s(h_over_d);
        const auto hydrostatic = [&](const Vec<Dim>& x) { return 1000 * g * (1 - x[1]); };
        for (std::size_t i = 0; i < s.fluid.size(); ++i) s.fluid.pressure[i] = hydrostatic(s.fluid.position[i]);
        s.take_pressure(downwards<Dim>(g));
        for (std::size_t i = 0; i < s.wall.size(); ++i)
            if (wet(s, i))
                REQUIRE(s.wall.pressure[i] ==
                        Approx(hydrostatic(s.wall.position[i])).epsilon(1e-13));  // linear in, linear out

        // The wall then carries the water: −∇p/ρ = g upwards, off by the lattice's own factor on a linear field, 2 %.
        const auto a = s.acceleration();
        for (std::size_t i = 0; i < s.fluid.size(); ++i)
            if (s.deep(s.fluid.position[i])) REQUIRE(a[i][1] == Approx(g).epsilon(0.02));
    }
}

TEMPLATE_TEST_CASE_SIG("ghosts push but do not pull", "[fixed_ghosts]", ((int Dim), Dim), 2, 3) {
    Random random(1);
    FlatWall<Dim> s(1.5);
    for (double& p : s.fluid.pressure) p = random.in(-3000, 2000);
    s.take_pressure(downwards<Dim>(9.81));
    std::size_t none = 0, some = 0;
    for (const double p : s.wall.pressure) {
        REQUIRE(p >= 0);
        (p == 0 ? none : some) += 1;
    }
    CHECK(none > 0);
    CHECK(some > 0);
}

TEMPLATE_TEST_CASE_SIG("density rises by approach to a wall of ghosts, not by sliding along it", "[fixed_ghosts]",
                       ((int Dim), Dim), 2, 3) {
    FlatWall<Dim> s(1.5);
    const auto rates = [&](double along, double normal) {
        for (std::size_t i = 0; i < s.fluid.size(); ++i) {
            Vec<Dim> v;
            v[0] = along;
            v[1] = normal;
            s.fluid.velocity.set(i, v);
        }
        ScalarField rate(s.fluid.size(), 0.0);
        fixed_ghost_continuity<Dim>(s.fluid.view(), s.wall.view(), s.fluid_wall, Precision::full, rate);
        return rate;
    };
    const ScalarField approach = rates(0, -1), parting = rates(0, 1), slip = rates(1, 0);
    std::size_t checked = 0;
    for (std::size_t i = 0; i < s.fluid.size(); ++i) {
        if (!s.deep(s.fluid.position[i]) || s.fluid.position[i][1] > spacing) continue;
        ++checked;
        REQUIRE(approach[i] > 0);
        REQUIRE(parting[i] == -approach[i]);
        REQUIRE(std::abs(slip[i]) < 1e-13 * approach[i]);  // left and right cancel
    }
    CHECK(checked > 0);
}

}  // namespace sluice::test_fixed_ghosts
