// A flat interface under a static pressure: equations 24–28 where the answer is known, p on every element and p·A on
// the wall, whatever the spacing of the elements.
#include <map>

#include "kernels/passes/fluid_passes.hpp"
#include "kernels/passes/interface_passes.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_boundary.hpp"

namespace sluice::test_flat_interface {

namespace {

constexpr double spacing = 0.1;  // [m]
constexpr double load = 1400;    // [Pa], a column of 0.14 m of water

/// Solid below the plane y = 0, fluid above it at one pressure, elements on it, spacing/divisor apart. Elements stand
/// well inside the blocks' faces, so that every one has full half-supports.
template <int Dim>
struct FlatInterface {
    Particles<Dim> solid, fluid;
    Elements<Dim> elements;
    double area = 0;

    FlatInterface(double h_over_d, int divisor, double shift) {
        const int margin = 4, half = Dim == 2 ? 6 : 4, depth = 5;
        auto below = cube<Dim>(half + margin, spacing, h_over_d);
        below.lo.fill(-half - margin);
        auto above = below;
        below.lo[1] = -depth;
        below.hi[1] = 0;
        above.lo[1] = 0;
        above.hi[1] = depth;
        solid = lattice(below);
        fluid = lattice(above);
        std::fill(fluid.pressure.begin(), fluid.pressure.end(), load);
        fluid.derive();

        const double step = spacing / divisor;
        Vec<Dim> n;
        n[1] = std::pow(step, Dim - 1);
        const int steps = 2 * half * divisor;
        for (int i = 0; i < steps; ++i)
            for (int k = 0; k < (Dim == 3 ? steps : 1); ++k) {
                Vec<Dim> x;
                x[0] = -half * spacing + (i + shift) * step;
                if (Dim == 3) x[Dim - 1] = -half * spacing + (k + shift) * step;
                elements.add(x, n);
                area += n[1];
            }
    }
    InterfaceResult<Dim> evaluate() {
        return evaluate_interface<Dim>(elements, fluid, solid, {elements, fluid, solid});
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("a static pressure p loads every element with p and the wall with p A", "[interface]",
                       ((int Dim), Dim), 2, 3) {
    for (const double h_over_d : {1.2, 1.3, 1.5, 1.7, 2.0})
        for (const int divisor : {1, 2, 4})
            for (const double shift : {0.5, 0.0}) {  // under the particles' columns or between them
                FlatInterface<Dim> s(h_over_d, divisor, shift);
                const auto r = s.evaluate();
                double worst = 0;
                for (const double p : s.elements.pressure) worst = std::max(worst, std::abs(p / load - 1));
                CAPTURE(h_over_d, divisor, shift, worst);
                // Half of the lattice's sum Σ V W, which is 1 within 1 % in a plane midway between layers.
                CHECK(worst < 0.01);
                CHECK(-r.on_solid[1] / (load * s.area) == Approx(1).margin(0.01));
                // Nothing along the wall: normals are exact.
                CHECK(r.on_solid[0] == 0);
            }
}

TEMPLATE_TEST_CASE_SIG("the wall's load reaches the solid's layers as the integral of W does", "[interface]",
                       ((int Dim), Dim), 2, 3) {
    // −2 n p ∫_Γ W dΓ per volume: by layers of depth s the share is V_a W/Σ V W, whose limit is 2 d ∫_Γ W(s) dΓ.
    const double h_over_d = 1.5, h = h_over_d * spacing;
    FlatInterface<Dim> s(h_over_d, 4, 0.5);
    const auto r = s.evaluate();
    std::map<int, double> by_layer;
    for (std::size_t a = 0; a < s.solid.size(); ++a)
        by_layer[static_cast<int>(std::floor(-s.solid.position[a][1] / spacing))] +=
            s.solid.mass[a] * r.solid_acceleration[a][1];
    double total = 0;
    for (const auto& [layer, force] : by_layer) {
        const double depth = (layer + 0.5) * spacing;
        double integral = 0;  // ∫_Γ W dΓ at this depth, by the midpoint rule
        const int steps = 2000;
        for (int n = 0; n < steps; ++n) {
            const double t = (n + 0.5) * 2 * h / steps, ring = Dim == 2 ? 2 : 2 * std::numbers::pi * t;
            integral += ring * twin::w(Dim, std::hypot(depth, t), h) * 2 * h / steps;
        }
        CAPTURE(layer);
        CHECK(-force / (load * s.area) ==
              Approx(2 * spacing * integral).margin(0.01));  // the lattice's error, as above
        total -= force / (load * s.area);
    }
    CHECK(total == Approx(1).margin(0.01));
}

TEMPLATE_TEST_CASE_SIG("the pressure fades as the media part", "[interface]", ((int Dim), Dim), 2, 3) {
    double last = load * 1.01;
    for (const double gap : {0.0, 0.05, 0.1, 0.2, 0.29}) {
        FlatInterface<Dim> s(1.5, 1, 0.5);
        for (double& y : s.fluid.position.c[1]) y += gap;
        s.evaluate();
        CAPTURE(gap);
        CHECK(s.elements.pressure[0] < last);
        last = s.elements.pressure[0];
    }
    CHECK(last == 0);  // at 2h − d/2 = 0.25 m the nearest particles leave the support
}

TEMPLATE_TEST_CASE_SIG("a particle at the wall is driven from high pressure to low", "[interface]", ((int Dim), Dim), 2,
                       3) {
    for (const double h_over_d : {1.3, 1.5, 1.8})
        for (const double excess : {0.5 * load, -0.5 * load}) {
            FlatInterface<Dim> s(h_over_d, 1, 0.5);
            std::size_t near = 0;  // a particle of the first layer, in the middle
            for (std::size_t b = 0; b < s.fluid.size(); ++b)
                if (norm2(s.fluid.position[b]) < norm2(s.fluid.position[near])) near = b;
            const auto vertical = [&] {
                auto a = s.evaluate().fluid_acceleration;
                fluid_momentum<Dim>(s.fluid.view(), list_of(s.fluid), {}, Precision::full, a);
                return a[near];
            };
            const double at_rest = vertical()[1];
            s.fluid.pressure[near] += excess;
            s.fluid.derive();
            const Vec<Dim> pushed = vertical();
            CAPTURE(h_over_d, excess);
            CHECK(pushed[1] * excess > 0);
            CHECK((pushed[1] - at_rest) * excess > 0);
            // Uniform pressure: −2p/ρ Σ V ∇W against the surface term 2p/ρ ∫ W n dΓ. On a lattice they differ by 2 % of
            // 2p/(ρ d), towards the wall: the sum of the first layers misses a little of the integral.
            CHECK(std::abs(at_rest) < 0.025 * 2 * load / (1000 * spacing));
            CHECK(std::abs(pushed[0]) <
                  1e-10 * std::abs(pushed[1]));  // symmetric: rounding of thousandfold larger terms
        }
}

}  // namespace sluice::test_flat_interface
