// What pair forces keep: momentum, angular momentum, and energy between pressure and continuity.
#include "kernels/solid_passes.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"

using namespace sluice;

namespace {

/// |Σ m a| / Σ m |a|
template <int Dim>
double momentum_defect(const Particles<Dim>& p, const VectorField<Dim>& a) {
    Vec<Dim> sum;
    double size = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        sum += p.mass[i] * a[i];
        size += p.mass[i] * norm(a[i]);
    }
    REQUIRE(size > 0);
    return norm(sum) / size;
}

/// |Σ x × m a| / Σ |x| m |a| in the plane of the axes j and k.
template <int Dim>
double angular_defect(const Particles<Dim>& p, const VectorField<Dim>& a, int j, int k) {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        sum += p.mass[i] * (p.position[i][j] * a[i][k] - p.position[i][k] * a[i][j]);
        size += p.mass[i] * norm(p.position[i]) * norm(a[i]);
    }
    return std::abs(sum) / size;
}

/// Each pair's two forces differ by the rounding of its separation, taken from two groups' origins, and of its slope:
/// 1e-13 and 1e-5 for the closest pairs, less in the mean over thousands of pairs.
template <class Real>
constexpr double pair_rounding = sizeof(Real) == 8 ? 1e-12 : 1e-5;

}  // namespace

TEMPLATE_TEST_CASE_SIG("every pair term of the fluid keeps momentum", "[conservation]",
                       ((int Dim, class Real), Dim, Real), (2, double), (2, float), (3, double), (3, float)) {
    for (const Scene scene : scenes)
        for (const double alpha : {0.0, 0.5}) {
            const auto p = make_scene<Dim>(scene, 2);
            auto a = zeros<Dim>(p.size());
            fluid_momentum<Dim, Real>(p.view(), list_of(p), {alpha, 30}, a);
            CAPTURE(static_cast<int>(scene), alpha);
            CHECK(momentum_defect<Dim>(p, a) < pair_rounding<Real>);
        }
}

TEMPLATE_TEST_CASE_SIG("every pair term of the solid keeps momentum", "[conservation]",
                       ((int Dim, class Real), Dim, Real), (2, double), (2, float), (3, double), (3, float)) {
    for (const Scene scene : scenes)
        for (const double alpha : {0.0, 1.0})
            for (const double e : {0.0, 0.3}) {
                const auto p = make_scene<Dim>(scene, 3);
                auto a = zeros<Dim>(p.size());
                solid_momentum<Dim, Real>(p.view(), list_of(p), {alpha, 134.8, e, 4, 1.3}, a);
                CAPTURE(static_cast<int>(scene), alpha, e);
                CHECK(momentum_defect<Dim>(p, a) < pair_rounding<Real>);
            }
}

TEMPLATE_TEST_CASE_SIG("pressure and viscosity act along the line between two particles and keep angular momentum",
                       "[conservation]", ((int Dim), Dim), 2, 3) {
    for (const Scene scene : scenes)
        for (const double alpha : {0.0, 0.5}) {
            const auto p = make_scene<Dim>(scene, 4);
            auto a = zeros<Dim>(p.size());
            fluid_momentum<Dim, double>(p.view(), list_of(p), {alpha, 30}, a);
            CAPTURE(static_cast<int>(scene), alpha);
            for (int j = 0; j < Dim; ++j)
                for (int k = j + 1; k < Dim; ++k) CHECK(angular_defect<Dim>(p, a, j, k) < pair_rounding<double>);
        }
}

TEMPLATE_TEST_CASE_SIG("the power of the pressure is what compression takes up", "[conservation]", ((int Dim), Dim), 2,
                       3) {
    // Σ m v·a = −Σ m p/ρ² dρ/dt: eqs. (8) and (10) are one variational pair, for unequal m and h too.
    for (const Scene scene : scenes) {
        const auto p = make_scene<Dim>(scene, 5);
        const NeighborList list = list_of(p);
        auto a = zeros<Dim>(p.size());
        ScalarField rate(p.size(), 0.0);
        fluid_momentum<Dim, double>(p.view(), list, {}, a);
        continuity<Dim, double>(p.view(), list, rate);
        double power = 0, compression = 0, size = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            power += p.mass[i] * dot(p.velocity[i], a[i]);
            size += p.mass[i] * norm(p.velocity[i]) * norm(a[i]);
            compression += p.mass[i] * p.pressure_over_rho2[i] * rate[i];
        }
        CAPTURE(static_cast<int>(scene));
        CHECK(std::abs(power + compression) < 1e-12 * size);  // rounding of a pair, as above
        CHECK(std::abs(power) > 1e-4 * size);
    }
}

TEMPLATE_TEST_CASE_SIG("a uniform velocity changes no density and is not filtered", "[conservation]",
                       ((int Dim, class Real), Dim, Real), (2, double), (2, float), (3, double), (3, float)) {
    for (const Scene scene : scenes) {
        auto p = make_scene<Dim>(scene, 6);
        for (int k = 0; k < Dim; ++k) {
            auto& v = p.velocity.c[static_cast<std::size_t>(k)];
            std::fill(v.begin(), v.end(), 0.3 - k);
        }
        const NeighborList list = list_of(p);
        ScalarField rate(p.size(), 0.0), solid_rate(p.size(), 0.0);
        auto correction = zeros<Dim>(p.size());
        auto l = zeros<Dim * Dim>(p.size());
        continuity<Dim, Real>(p.view(), list, rate);
        solid_rates<Dim, Real>(p.view(), list, solid_rate, l);
        velocity_filter<Dim, Real>(p.view(), list, 0.92, correction);
        CAPTURE(static_cast<int>(scene));
        // Differences of equal numbers: exactly zero.
        CHECK((rate == ScalarField(p.size(), 0.0)));
        CHECK((solid_rate == ScalarField(p.size(), 0.0)));
        CHECK(same_bits(correction, zeros<Dim>(p.size())));
        CHECK(same_bits(l, zeros<Dim * Dim>(p.size())));
    }
}

TEMPLATE_TEST_CASE_SIG("the filter never widens the range of velocities", "[conservation]", ((int Dim), Dim), 2, 3) {
    // ṽ is a mean of the neighbours' velocities with weights that are positive and add up to one.
    const auto p = make_scene<Dim>(Scene::unequal, 7);
    auto correction = zeros<Dim>(p.size());
    velocity_filter<Dim, double>(p.view(), list_of(p), 0.0, correction);
    for (int k = 0; k < Dim; ++k) {
        const auto& v = p.velocity.c[static_cast<std::size_t>(k)];
        const auto [lowest, highest] = std::minmax_element(v.begin(), v.end());
        std::size_t outside = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double filtered = v[i] + correction[i][k];
            outside += filtered < *lowest - 1e-14 || filtered > *highest + 1e-14;  // rounding of a velocity of 2 m/s
        }
        CHECK(outside == 0);
    }
}
