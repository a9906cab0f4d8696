// What pair forces keep: momentum, angular momentum, and energy between pressure and continuity.
#include "kernels/passes/density_passes.hpp"
#include "kernels/passes/fluid_passes.hpp"
#include "kernels/passes/solid_passes.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"

namespace sluice::test_conservation {

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

/// Each pair's two forces differ by the rounding of its separation, taken from two blocks' origins, and of its slope:
/// 1e-13 and 1e-5 for the closest pairs, less in the mean over thousands of pairs.
constexpr double pair_rounding(Precision precision) { return precision == Precision::full ? 1e-12 : 1e-5; }

/// The fluid without viscosity, and with each kind that acts along the line between two particles.
constexpr FluidTerms central_terms[] = {{}, {0.5, 30}, {0, 0, Viscosity::monaghan_gingold, 0.3}};
constexpr FluidTerms all_terms[] = {
    {}, {0.5, 30}, {0, 0, Viscosity::monaghan_gingold, 0.3}, {0, 0, Viscosity::morris, 0.3}};

/// dρ/dt by the loop that a fluid with this diffusion runs; Antuono's takes gradients of zero.
template <int Dim>
ScalarField density_rates(const Particles<Dim>& p, const NeighborList& list, DensityDiffusion kind,
                          Precision precision) {
    const auto no_gradient = zeros<Dim>(p.size());
    auto view = p.view();
    view.density_gradient = columns_of(no_gradient);
    ScalarField rate(p.size(), 0.0);
    diffusive_continuity<Dim>(view, list, {kind, 30, 0.1, 1000, {}}, precision, rate);
    return rate;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("every pair term of the fluid keeps momentum", "[conservation]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(2, [](const auto& p, const NeighborList& list) {
        in_all_variants([&](Precision precision) {
            for (const FluidTerms& terms : all_terms) {
                auto a = zeros<Dim>(p.size());
                fluid_momentum<Dim>(p.view(), list, terms, precision, a);
                CAPTURE(static_cast<int>(terms.viscosity));
                CHECK(momentum_defect<Dim>(p, a) < pair_rounding(precision));
            }
        });
    });
}

TEMPLATE_TEST_CASE_SIG("every pair term of the solid keeps momentum", "[conservation]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(3, [](const auto& p, const NeighborList& list) {
        in_all_variants([&](Precision precision) {
            for (const double alpha : {0.0, 1.0})
                for (const double e : {0.0, 0.3}) {
                    auto a = zeros<Dim>(p.size());
                    solid_momentum<Dim>(p.view(), list, {alpha, 134.8, e, 4, 1.3}, precision, a);
                    CAPTURE(alpha, e);
                    CHECK(momentum_defect<Dim>(p, a) < pair_rounding(precision));
                }
        });
    });
}

TEMPLATE_TEST_CASE_SIG("pressure and viscosity act along the line between two particles and keep angular momentum",
                       "[conservation]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(4, [](const auto& p, const NeighborList& list) {
        in_all_variants([&](Precision precision) {
            for (const FluidTerms& terms : central_terms) {
                auto a = zeros<Dim>(p.size());
                fluid_momentum<Dim>(p.view(), list, terms, precision, a);
                CAPTURE(static_cast<int>(terms.viscosity));
                for (int j = 0; j < Dim; ++j)
                    for (int k = j + 1; k < Dim; ++k) CHECK(angular_defect<Dim>(p, a, j, k) < pair_rounding(precision));
            }
        });
    });
}

TEMPLATE_TEST_CASE_SIG("the power of the pressure is what compression takes up", "[conservation]", ((int Dim), Dim), 2,
                       3) {
    // Σ m v·a = −Σ m p/ρ² dρ/dt: eqs. (8) and (10) are one variational pair, for unequal m and h too. In the loops with
    // diffusion that is so of what they add to the rates of the same fluid at rest.
    in_all_scenes<Dim>(5, [](const auto& p, const NeighborList& list) {
        auto at_rest = p;
        for (auto& column : at_rest.velocity.c) std::fill(column.begin(), column.end(), 0.0);
        in_all_variants([&](Precision precision) {
            auto a = zeros<Dim>(p.size());
            fluid_momentum<Dim>(p.view(), list, {}, precision, a);
            for (const DensityDiffusion kind : {DensityDiffusion::none, DensityDiffusion::molteni_colagrossi,
                                                DensityDiffusion::fourtakas, DensityDiffusion::antuono}) {
                const auto rate = density_rates<Dim>(p, list, kind, precision),
                           diffusion = density_rates<Dim>(at_rest, list, kind, precision);
                double power = 0, compression = 0, size = 0;
                for (std::size_t i = 0; i < p.size(); ++i) {
                    const double p_over_rho2 = p.pressure_over_rho2[i];
                    power += p.mass[i] * dot(p.velocity[i], a[i]);
                    size += p.mass[i] * (norm(p.velocity[i]) * norm(a[i]) + std::abs(p_over_rho2 * diffusion[i]));
                    compression += p.mass[i] * p_over_rho2 * (rate[i] - diffusion[i]);
                }
                CAPTURE(static_cast<int>(kind));
                CHECK(std::abs(power + compression) < pair_rounding(precision) * size);
                CHECK(std::abs(power) > 1e-4 * size);
            }
        });
    });
}

TEMPLATE_TEST_CASE_SIG("a uniform velocity changes no density and is not filtered", "[conservation]", ((int Dim), Dim),
                       2, 3) {
    in_all_scenes<Dim>(6, [](auto p, const NeighborList& list) {
        for (int k = 0; k < Dim; ++k) {
            auto& v = p.velocity.c[static_cast<std::size_t>(k)];
            std::fill(v.begin(), v.end(), 0.3 - k);
        }
        in_all_variants([&](Precision precision) {
            ScalarField rate(p.size(), 0.0), solid_rate(p.size(), 0.0);
            auto correction = zeros<Dim>(p.size());
            auto l = zeros<Dim * Dim>(p.size());
            continuity<Dim>(p.view(), list, precision, rate);
            solid_rates<Dim>(p.view(), list, precision, solid_rate, l);
            velocity_filter<Dim>(p.view(), list, 0.92, precision, correction);
            // Differences of equal numbers: exactly zero.
            CHECK((rate == ScalarField(p.size(), 0.0)));
            CHECK((solid_rate == ScalarField(p.size(), 0.0)));
            CHECK(same_bits(correction, zeros<Dim>(p.size())));
            CHECK(same_bits(l, zeros<Dim * Dim>(p.size())));
        });
    });
}

TEMPLATE_TEST_CASE_SIG("the filter never widens the range of velocities", "[conservation]", ((int Dim), Dim), 2, 3) {
    // ṽ is a mean of the neighbours' velocities with weights that are positive and add up to one.
    const auto p = make_scene<Dim>(Scene::unequal, 7);
    const NeighborList list = list_of(p);
    in_all_variants([&](Precision precision) {
        auto correction = zeros<Dim>(p.size());
        velocity_filter<Dim>(p.view(), list, 0.0, precision, correction);
        const double rounding = precision == Precision::full ? 1e-14 : 1e-6;  // of a velocity of 2 m/s
        for (int k = 0; k < Dim; ++k) {
            const auto& v = p.velocity.c[static_cast<std::size_t>(k)];
            const auto [lowest, highest] = std::minmax_element(v.begin(), v.end());
            std::size_t outside = 0;
            for (std::size_t i = 0; i < p.size(); ++i) {
                const double filtered = v[i] + correction[i][k];
                outside += filtered < *lowest - rounding || filtered > *highest + rounding;
            }
            CHECK(outside == 0);
        }
    });
}

}  // namespace sluice::test_conservation
