// Artificial viscosity takes energy out and never puts it in; artificial stress pushes apart what is in tension.
#include "kernels/materials/tensile_correction.hpp"
#include "kernels/passes/fluid_passes.hpp"
#include "kernels/passes/solid_passes.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"

namespace sluice::test_dissipation {

namespace {

constexpr FluidTerms artificial{1, 30}, monaghan_gingold{0, 0, Viscosity::monaghan_gingold, 0.3},
    morris{0, 0, Viscosity::morris, 0.3};

/// Acceleration by viscosity alone.
template <int Dim>
VectorField<Dim> viscous_acceleration(Particles<Dim> p, const NeighborList& list, Precision precision,
                                      const FluidTerms& terms = artificial) {
    std::fill(p.pressure.begin(), p.pressure.end(), 0.0);
    p.derive();
    auto a = zeros<Dim>(p.size());
    fluid_momentum<Dim>(p.view(), list, terms, precision, a);
    return a;
}

template <int Dim>
double power(const Particles<Dim>& p, const VectorField<Dim>& a) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p.mass[i] * dot(p.velocity[i], a[i]);
    return sum;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("viscosity does nothing to particles that part", "[dissipation]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](auto p, const NeighborList& list) {
        for (std::size_t i = 0; i < p.size(); ++i) p.velocity.set(i, 3.0 * p.position[i]);
        in_all_variants([&](Precision precision) {
            const auto a = viscous_acceleration<Dim>(p, list, precision);
            // Where rounding decides who parts and who approaches, what is left is rounding: v is good to 1e-6 m/s, of
            // a scene's 1 m/s.
            const auto random = viscous_acceleration<Dim>(make_scene<Dim>(Scene::jittered), list, Precision::full);
            double worst = 0, usual = 0;
            for (std::size_t i = 0; i < p.size(); ++i) {
                worst = std::max(worst, norm(a[i]));
                usual = std::max(usual, norm(random[i]));
            }
            CHECK(worst <= (precision == Precision::full ? 0 : 1e-5) * usual);
        });
    });
}

TEMPLATE_TEST_CASE_SIG("viscosity takes kinetic energy, for random velocities and for a compression", "[dissipation]",
                       ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](auto p, const NeighborList& list) {
        const auto check = [&] {
            in_all_variants([&](Precision precision) {
                for (const FluidTerms& terms : {artificial, monaghan_gingold, morris})
                    CHECK(power(p, viscous_acceleration<Dim>(p, list, precision, terms)) < 0);
            });
        };
        check();
        for (std::size_t i = 0; i < p.size(); ++i) p.velocity.set(i, -1.0 * p.position[i]);
        check();
    });
}

TEMPLATE_TEST_CASE_SIG("viscosity along the line lets a fluid turn as a rigid body", "[dissipation]", ((int Dim), Dim),
                       2, 3) {
    in_all_scenes<Dim>(1, [](auto p, const NeighborList& list) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            Vec<Dim> v;
            v[0] = -3 * p.position[i][1];
            v[1] = 3 * p.position[i][0];
            p.velocity.set(i, v);
        }
        in_all_variants([&](Precision precision) {
            const auto turning = viscous_acceleration<Dim>(p, list, precision, monaghan_gingold);
            const auto random =
                viscous_acceleration<Dim>(make_scene<Dim>(Scene::jittered), list, Precision::full, monaghan_gingold);
            double worst = 0, usual = 0;
            for (std::size_t i = 0; i < p.size(); ++i) {
                worst = std::max(worst, norm(turning[i]));
                usual = std::max(usual, norm(random[i]));
            }
            // Each v·x is zero but for the rounding of v and x, 1e-16 or 1e-7 of 10 m/s where a scene has 1 m/s.
            CHECK(worst < (precision == Precision::full ? 1e-13 : 1e-4) * usual);
        });
    });
}

TEMPLATE_TEST_CASE_SIG("two particles: viscosity brakes the approach, along the line only", "[dissipation]",
                       ((int Dim), Dim), 2, 3) {
    Particles<Dim> p;
    Vec<Dim> x, v;
    x[0] = 0.1;
    v[0] = -1;
    v[1] = 5;  // slides past
    p.add({}, 0.1, 2, 1000);
    p.add(x, 0.1, 3, 1000);
    p.velocity.set(1, v);
    const auto a = viscous_acceleration<Dim>(p, list_of(p), Precision::full);
    // Π = α c h (v·x/(r² + 0.01 h²))/ρ̄ with v·x = −0.1: 30 · 0.1 · (0.1/0.0101)/1000.
    const double pi = 30 * 0.1 * (0.1 / (0.01 + 0.01 * 0.01)) / 1000, slope = -twin::dw_dr(Dim, 0.1, 0.1);
    CHECK(a[1][0] == Approx(2 * pi * slope).epsilon(1e-13));  // some ten roundings, and 1/h³ or 1/h⁴ in another order
    CHECK(a[0][0] == Approx(-3 * pi * slope).epsilon(1e-13));
    CHECK(a[0][1] == 0);
    CHECK(a[1][1] == 0);
}

TEMPLATE_TEST_CASE_SIG("the fluid's filter takes kinetic energy", "[dissipation]", ((int Dim), Dim), 2, 3) {
    auto p = lattice(cube<Dim>(Dim == 2 ? 20 : 8, 0.1, 1.5));
    Random random(3);
    for (std::size_t i = 0; i < p.size(); ++i) p.velocity.set(i, random.vector<Dim>(-1, 1));
    auto correction = zeros<Dim>(p.size());
    velocity_filter<Dim>(p.view(), list_of(p), 0.92, Precision::full, correction);
    double before = 0, after = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        before += norm2(p.velocity[i]);
        after += norm2(p.velocity[i] + correction[i]);
    }
    // Uncorrelated velocities: a mean over n neighbours with weights w has Σ w² of the variance; at θ = 0.92 some
    // 2 · 0.08 of the energy goes, less the particle's own weight.
    CHECK(after / before == Approx(1 - 2 * 0.08).margin(0.04));
}

TEMPLATE_TEST_CASE_SIG("artificial stress pushes apart what is in tension and spares what is not", "[dissipation]",
                       ((int Dim), Dim), 2, 3) {
    for (const double sigma : {1e5, -1e5}) {
        Particles<Dim> p;
        Vec<Dim> x;
        x[0] = 0.1;
        p.add({}, 0.13, 1, 1000);
        p.add(x, 0.13, 1, 1000);
        Vec<sym_components<Dim>> along;
        along[0] = sigma;
        for (const std::size_t i : {0, 1}) {
            p.stress.set(i, along);
            p.artificial_stress.set(i, tensile_correction((1e-6) * along, 0.3));
        }
        p.derive();
        const auto force = [&](double e) {
            auto a = zeros<Dim>(2);
            solid_momentum<Dim>(p.view(), list_of(p), {0, 0, e, 4, 1.3}, Precision::full, a);
            return a[1][0];
        };
        CAPTURE(sigma);
        CHECK(force(0) * sigma < 0);  // tension pulls, compression pushes
        // At the initial spacing f = 1: the pull is less by the factor 1 − e.
        CHECK(force(0.3) == Approx(force(0) * (sigma > 0 ? 0.7 : 1)).epsilon(1e-13));  // some ten roundings
    }
}

}  // namespace sluice::test_dissipation
