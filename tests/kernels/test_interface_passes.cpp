// The passes of the interface against their plain twins, equation by equation of interface_passes.hpp.
#include "kernels/passes/interface_passes.hpp"

#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_boundary.hpp"

namespace sluice::test_interface_passes {

namespace {

/// W between element k and particle b, with the particle's own h.
template <int Dim>
double w_of(const Elements<Dim>& e, std::size_t k, const Particles<Dim>& p, std::size_t b) {
    return twin::PairOf<Dim>(e.position[k], p.position[b], p.h[b]).w;
}

/// All results of one evaluation, as sums over every element and every particle.
template <int Dim>
struct Expected {
    twin::Sums<1> pressure, weight, density_rate;
    twin::Sums<Dim> velocity, on_solid, on_fluid;  // velocity: v_k, on_…: accelerations

    Expected(const Elements<Dim>& e, const Particles<Dim>& fluid, const Particles<Dim>& solid) {
        for (auto* s : {&pressure, &weight}) *s = empty<1>(e.size());
        density_rate = empty<1>(fluid.size());
        velocity = empty<Dim>(e.size());
        on_solid = empty<Dim>(solid.size());
        on_fluid = empty<Dim>(fluid.size());
        for (std::size_t k = 0; k < e.size(); ++k) {
            for (std::size_t b = 0; b < fluid.size(); ++b)
                add(pressure, k,
                    Vec<1>{{2 * fluid.mass[b] / fluid.density[b] * fluid.pressure[b] * w_of(e, k, fluid, b)}});
            for (std::size_t a = 0; a < solid.size(); ++a)
                add(weight, k, Vec<1>{{solid.mass[a] / solid.density[a] * w_of(e, k, solid, a)}});
            for (std::size_t a = 0; a < solid.size(); ++a) {
                const double share = solid.mass[a] / solid.density[a] * w_of(e, k, solid, a) / weight.value[k][0];
                add(velocity, k, share * solid.velocity[a]);
                add(on_solid, a, (-share * pressure.value[k][0] / solid.mass[a]) * e.area_normal[k]);
            }
            for (std::size_t b = 0; b < fluid.size(); ++b) {
                const double v_w = fluid.mass[b] / fluid.density[b] * w_of(e, k, fluid, b);
                add(on_fluid, b, (2 * v_w * fluid.pressure[b] / fluid.mass[b]) * e.area_normal[k]);
                double approach = 0;
                for (int c = 0; c < Dim; ++c)
                    approach += e.area_normal[k][c] * (fluid.velocity[b][c] - velocity.value[k][c]);
                add(density_rate, b, Vec<1>{{-2 * fluid.density[b] * w_of(e, k, fluid, b) * approach}});
            }
        }
    }

  private:
    template <int N>
    static twin::Sums<N> empty(std::size_t n) {
        return {std::vector<Vec<N>>(n), std::vector<Vec<N>>(n)};
    }
    template <int N>
    static void add(twin::Sums<N>& sums, std::size_t i, const Vec<N>& t) {
        for (int c = 0; c < N; ++c) {
            sums.value[i][c] += t[c];
            sums.magnitude[i][c] += std::abs(t[c]);
        }
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("the interface passes equal their twins", "[interface]", ((int Dim), Dim), 2, 3) {
    for (const unsigned seed : {1u, 2u}) {
        IrregularInterface<Dim> s(seed);
        const Expected<Dim> expected(s.elements, s.fluid, s.solid);
        const auto got = evaluate_interface<Dim>(s.elements, s.fluid, s.solid, {s.elements, s.fluid, s.solid});
        // Quotients and products of sums: a few times the error of one.
        const double tolerance = 1e-12;
        CHECK(worst_error(s.elements.pressure, expected.pressure) < tolerance);
        CHECK(worst_error(s.elements.weight, expected.weight) < tolerance);
        CHECK(worst_error(s.elements.velocity, expected.velocity) < tolerance);
        CHECK(worst_error(got.solid_acceleration, expected.on_solid) < tolerance);
        CHECK(worst_error(got.fluid_acceleration, expected.on_fluid) < tolerance);
        CHECK(worst_error(got.density_rate, expected.density_rate) < tolerance);
    }
}

TEMPLATE_TEST_CASE_SIG("the returned sums are the forces on the particles", "[interface]", ((int Dim), Dim), 2, 3) {
    IrregularInterface<Dim> s(3);
    const auto got = evaluate_interface<Dim>(s.elements, s.fluid, s.solid, {s.elements, s.fluid, s.solid});
    Vec<Dim> on_solid, on_fluid;
    double size = 0;
    for (std::size_t a = 0; a < s.solid.size(); ++a) on_solid += s.solid.mass[a] * got.solid_acceleration[a];
    for (std::size_t b = 0; b < s.fluid.size(); ++b) {
        on_fluid += s.fluid.mass[b] * got.fluid_acceleration[b];
        size += s.fluid.mass[b] * norm(got.fluid_acceleration[b]);
    }
    // Hundreds of terms, in two orders.
    CHECK(norm(on_solid - got.on_solid) < 1e-13 * size);
    CHECK(norm(on_fluid - got.on_fluid) < 1e-13 * size);
}

TEMPLATE_TEST_CASE_SIG("interface passes have the same bits for any number of threads", "[interface]", ((int Dim), Dim),
                       2, 3) {
    IrregularInterface<Dim> s(5);
    const InterfaceLists<Dim> lists(s.elements, s.fluid, s.solid);
    std::vector<InterfaceResult<Dim>> results;
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        results.push_back(evaluate_interface<Dim>(s.elements, s.fluid, s.solid, lists));
    }
    for (const std::size_t t : {1, 2}) {
        CHECK(same_bits(results[t].solid_acceleration, results[0].solid_acceleration));
        CHECK(same_bits(results[t].fluid_acceleration, results[0].fluid_acceleration));
        CHECK((results[t].density_rate == results[0].density_rate));
        CHECK(results[t].on_solid == results[0].on_solid);
        CHECK(results[t].on_fluid == results[0].on_fluid);
    }
}

}  // namespace sluice::test_interface_passes
