// What the interface keeps in any geometry: momentum, energy, and rest.
#include "kernels/passes/interface_passes.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_boundary.hpp"

namespace sluice::test_interface_balance {

namespace {

/// Σ m |a| over both media: what momentum may be wrong by is measured against it.
template <int Dim>
double total_force(const IrregularInterface<Dim>& s, const InterfaceResult<Dim>& r) {
    double sum = 0;
    for (std::size_t a = 0; a < s.solid.size(); ++a) sum += s.solid.mass[a] * norm(r.solid_acceleration[a]);
    for (std::size_t b = 0; b < s.fluid.size(); ++b) sum += s.fluid.mass[b] * norm(r.fluid_acceleration[b]);
    return sum;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the weights by which a force is shared out add up to one", "[interface]", ((int Dim), Dim), 2,
                       3) {
    IrregularInterface<Dim> s(6);
    const InterfaceLists<Dim> lists(s.elements, s.fluid, s.solid);
    auto& e = s.elements;
    interface_weights<Dim>(e.view(), s.solid.view(), lists.element_solid, {}, e.weight, e.velocity);
    BlockTotals<Dim> totals;
    Vec<Dim> unit;
    unit[0] = 1;
    for (std::size_t k = 0; k < s.elements.size(); k += 5) {
        auto a = zeros<Dim>(s.solid.size());
        e.force = zeros<Dim>(e.size());
        e.force.set(k, unit);
        e.share_forces();
        const Vec<Dim> sum =
            interface_force_on_solid<Dim>(s.solid.view(), e.view(), lists.solid_element, {}, totals, a);
        CHECK(norm(sum - unit) < 1e-14);  // some ten shares of one
    }
}

TEMPLATE_TEST_CASE_SIG("action and reaction cancel for any geometry and pressure", "[interface]", ((int Dim), Dim), 2,
                       3) {
    for (unsigned seed = 10; seed < 15; ++seed) {
        IrregularInterface<Dim> s(seed);
        const auto r = evaluate_interface<Dim>(s.elements, s.fluid, s.solid, {s.elements, s.fluid, s.solid});
        CAPTURE(seed);
        CHECK(norm(r.on_solid + r.on_fluid) < 1e-13 * total_force(s, r));  // thousands of terms of random sign
    }
}

TEMPLATE_TEST_CASE_SIG("the power of the forces is what the fluid's compression takes up", "[interface]",
                       ((int Dim), Dim), 2, 3) {
    for (unsigned seed = 30; seed < 33; ++seed) {
        IrregularInterface<Dim> s(seed);
        const auto r = evaluate_interface<Dim>(s.elements, s.fluid, s.solid, {s.elements, s.fluid, s.solid});
        double power = 0, size = 0, compression = 0;
        for (std::size_t a = 0; a < s.solid.size(); ++a) {
            const double part = s.solid.mass[a] * dot(r.solid_acceleration[a], s.solid.velocity[a]);
            power += part;
            size += std::abs(part);
        }
        for (std::size_t b = 0; b < s.fluid.size(); ++b) {
            const double part = s.fluid.mass[b] * dot(r.fluid_acceleration[b], s.fluid.velocity[b]);
            power += part;
            size += std::abs(part);
            compression +=
                s.fluid.mass[b] * s.fluid.pressure[b] / (s.fluid.density[b] * s.fluid.density[b]) * r.density_rate[b];
        }
        CAPTURE(seed);
        CHECK(std::abs(power + compression) < 1e-13 * size);  // thousands of terms of random sign
        CHECK(std::abs(power) > 1e-3 * size);                 // and it is no equation of zeros
    }
}

TEMPLATE_TEST_CASE_SIG("a common translation changes no density", "[interface]", ((int Dim), Dim), 2, 3) {
    IrregularInterface<Dim> s(40);
    for (auto* p : {&s.solid, &s.fluid})
        for (int k = 0; k < Dim; ++k)
            std::fill(p->velocity.c[static_cast<std::size_t>(k)].begin(),
                      p->velocity.c[static_cast<std::size_t>(k)].end(), 1.7 - k);
    const auto r = evaluate_interface<Dim>(s.elements, s.fluid, s.solid, {s.elements, s.fluid, s.solid});
    // v_k is a mean with weights that add up to one but for rounding; rates of a relative motion of 1 m/s are ρ/d ≈
    // 1e4.
    CHECK(*std::max_element(r.density_rate.begin(), r.density_rate.end()) < 1e-9);
    CHECK(*std::min_element(r.density_rate.begin(), r.density_rate.end()) > -1e-9);
}

TEMPLATE_TEST_CASE_SIG("an element moves with the solid around it", "[interface]", ((int Dim), Dim), 2, 3) {
    // On the face of a lattice the weights are symmetric: a velocity that is linear along the face is met exactly.
    auto box = cube<Dim>(10, 0.1, 1.5);
    box.lo.fill(-10);
    box.hi[1] = 0;
    auto solid = lattice(box);
    for (std::size_t a = 0; a < solid.size(); ++a) {
        Vec<Dim> v;
        v[1] = 3 + 2 * solid.position[a][0];
        solid.velocity.set(a, v);
    }
    Elements<Dim> e;
    for (int i = -3; i <= 3; ++i) {
        Vec<Dim> x, n;
        x[0] = (i + 0.5) * 0.1;
        n[1] = 1;
        e.add(x, n);
    }
    const auto list = list_between<Dim>(e.position, {}, solid.position, solid.h);
    interface_weights<Dim>(e.view(), solid.view(), list, {}, e.weight, e.velocity);
    for (std::size_t k = 0; k < e.size(); ++k)
        CHECK(e.velocity[k][1] == Approx(3 + 2 * e.position[k][0]).epsilon(1e-14));  // a mean of some fifty values
}

TEMPLATE_TEST_CASE_SIG("approach raises the density, parting lowers it, slip does neither", "[interface]",
                       ((int Dim), Dim), 2, 3) {
    const double d = 0.1;
    auto below = cube<Dim>(6, d, 1.5), above = below;
    below.lo.fill(-6);
    above.lo.fill(-6);
    below.hi[1] = 0;
    above.lo[1] = 0;
    const auto solid = lattice(below);
    auto fluid = lattice(above);
    Elements<Dim> e;
    Vec<Dim> n;
    n[1] = std::pow(d, Dim - 1);
    for (std::size_t a = 0; a < solid.size(); ++a)
        if (solid.position[a][1] > -d) {
            Vec<Dim> x = solid.position[a];
            x[1] = 0;
            e.add(x, n);
        }
    const InterfaceLists<Dim> lists(e, fluid, solid);
    const auto rates = [&](double along, double normal) {
        for (std::size_t b = 0; b < fluid.size(); ++b) {
            Vec<Dim> v;
            v[0] = along;
            v[1] = normal;
            fluid.velocity.set(b, v);
        }
        return evaluate_interface<Dim>(e, fluid, solid, lists).density_rate;
    };
    const ScalarField approach = rates(0, -1), parting = rates(0, 1), slip = rates(2, 0);
    std::size_t near = 0;
    for (std::size_t b = 0; b < fluid.size(); ++b) {
        if (fluid.position[b][1] > d) continue;
        ++near;
        REQUIRE(approach[b] > 0);
        REQUIRE(parting[b] == -approach[b]);
    }
    CHECK(near > 0);
    CHECK((slip == ScalarField(fluid.size(), 0.0)));
}

}  // namespace sluice::test_interface_balance
