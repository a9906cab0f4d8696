// Density diffusion: against its twins, what it keeps, what it leaves alone and how fast it damps.
#include <numbers>

#include "kernels/passes/density_passes.hpp"
#include "kernels/passes/fluid_passes.hpp"
#include "kernels/tensor.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins_fluid.hpp"

namespace sluice::test_density_diffusion {

namespace {

constexpr double c0 = 30, rho0 = 1000, delta = 0.1;

template <int Dim>
Vec<Dim> gravity() {
    Vec<Dim> g;
    for (int k = 0; k < Dim; ++k) g[k] = 3 - 5 * k;  // along no axis
    return g;
}

template <int Dim>
DiffusionTerms<Dim> terms_of(DensityDiffusion kind) {
    return {kind, c0, delta, rho0, gravity<Dim>()};
}

constexpr DensityDiffusion kinds[] = {DensityDiffusion::molteni_colagrossi, DensityDiffusion::fourtakas,
                                      DensityDiffusion::antuono};

template <int Dim>
ParticleView<Dim> view_with(const Particles<Dim>& p, const VectorField<Dim>& gradient) {
    auto v = p.view();
    v.density_gradient = columns_of(gradient);
    return v;
}

template <int Dim>
VectorField<Dim> random_vectors(std::size_t n, double size) {
    Random random(17);
    VectorField<Dim> f;
    for (std::size_t i = 0; i < n; ++i) f.push_back(random.vector<Dim>(-size, size));
    return f;
}

/// E_ij as the papers have it.
template <int Dim>
double expected_difference(const Particles<Dim>& p, const VectorField<Dim>& gradient, DensityDiffusion kind,
                           std::size_t i, std::size_t j) {
    double e = 0;
    for (int k = 0; k < Dim; ++k) {
        const double away = p.position[j][k] - p.position[i][k];
        if (kind == DensityDiffusion::fourtakas) e += rho0 * gravity<Dim>()[k] / (c0 * c0) * away;
        if (kind == DensityDiffusion::antuono) e += (gradient[i][k] + gradient[j][k]) / 2 * away;
    }
    return e;
}

/// Diffusion alone: density rates of particles at rest, with gradients taken by the pass.
template <int Dim>
ScalarField diffusion_rates(Particles<Dim> p, const NeighborList& list, DensityDiffusion kind,
                            Precision precision = Precision::full) {
    for (auto& column : p.velocity.c) std::fill(column.begin(), column.end(), 0.0);
    auto gradient = zeros<Dim>(p.size());
    ScalarField rate(p.size(), 0.0);
    density_gradient<Dim>(p.view(), list, precision, gradient);
    diffusive_continuity<Dim>(view_with(p, gradient), list, terms_of<Dim>(kind), precision, rate);
    return rate;
}

double largest(const ScalarField& f) {
    double most = 0;
    for (const double x : f) most = std::max(most, std::abs(x));
    return most;
}

/// ρ = ρ0 + G·x on particles in disorder, with unequal masses, free all around.
template <int Dim>
Particles<Dim> stratified(const Vec<Dim>& gradient) {
    Random random(2);
    auto p = lattice(cube<Dim>(Dim == 2 ? 16 : 8, 0.1, 1.5));
    jitter(p, 0.025, random);
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.density[i] = rho0 + dot(gradient, p.position[i]);
        p.mass[i] *= random.in(0.9, 1.1);
    }
    return p;
}

/// How fast the wave sin(2πx) in a cube of n cells decays, over δ h c0 k² of the diffusion equation ∂ρ/∂t = δ h c0 ∇²ρ.
template <int Dim>
double wave_damping(DensityDiffusion kind, int n) {
    const double d = 1.0 / n, h = 1.5 * d, k = 2 * std::numbers::pi;
    auto p = lattice(cube<Dim>(n, d, 1.5));
    for (std::size_t i = 0; i < p.size(); ++i) p.density[i] = rho0 + std::sin(k * p.position[i][0]);
    const ScalarField rate = diffusion_rates<Dim>(p, list_of(p), kind);
    double decay = 0, size = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        bool deep = true;  // gradients of neighbours with a full support too
        for (int l = 0; l < Dim; ++l) deep = deep && std::abs(p.position[i][l] - 0.5) < 0.5 - 4 * h;
        if (!deep) continue;
        decay -= (p.density[i] - rho0) * rate[i];
        size += (p.density[i] - rho0) * (p.density[i] - rho0);
    }
    return decay / (size * delta * h * c0 * k * k);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("continuity with each density diffusion equals its twin", "[density_diffusion]",
                       ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) {
        const auto gradient = random_vectors<Dim>(p.size(), 2000);  // [kg/m⁴]: 200 between neighbours, as the densities
        for (const DensityDiffusion kind : kinds) {
            const auto expected = twin::diffusive_continuity<Dim>(p, delta * c0, [&](std::size_t i, std::size_t j) {
                return expected_difference<Dim>(p, gradient, kind, i, j);
            });
            in_all_variants([&](Precision precision) {
                ScalarField rate(p.size(), 0.0);
                const auto pairs =
                    diffusive_continuity<Dim>(view_with(p, gradient), list, terms_of<Dim>(kind), precision, rate);
                CAPTURE(static_cast<int>(kind));
                CHECK(worst_error(rate, expected) < twin_tolerance(precision));
                CHECK(pairs == list.pairs());
            });
        }
    });
}

TEMPLATE_TEST_CASE_SIG("density_gradient is the quotient of its twin's sums", "[density_diffusion]", ((int Dim), Dim),
                       2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) {
        const auto sums = twin::density_gradient_sums<Dim>(p);
        in_all_variants([&](Precision precision) {
            auto gradient = zeros<Dim>(p.size());
            for (auto& column : gradient.c) column.assign(p.size(), 7.0);  // of an earlier step
            CHECK(density_gradient<Dim>(p.view(), list, precision, gradient) == list.pairs());
            double worst = 0;
            std::size_t undefined = 0, wrong = 0;
            for (std::size_t i = 0; i < p.size(); ++i) {
                Tensor<Dim> m, m_size;
                Eigen::Matrix<double, Dim, 1> g, sum, size;
                for (int k = 0; k < Dim; ++k) {
                    g[k] = gradient[i][k];
                    sum[k] = sums.value[i][k];
                    size[k] = sums.magnitude[i][k];
                    for (int l = 0; l < Dim; ++l) {
                        m(k, l) = sums.value[i][Dim + k * Dim + l];
                        m_size(k, l) = sums.magnitude[i][Dim + k * Dim + l];
                    }
                }
                if (std::abs(m.determinant() - 1e-3) < 1e-5) continue;  // on the threshold rounding decides
                if (m.determinant() < 1e-3) {
                    ++undefined;
                    wrong += g.norm() != 0;
                    continue;
                }
                // M g = Σ: what is left, in units of what rounding the sums may cost.
                worst =
                    std::max(worst, relative_error((m * g - sum).norm(), 0, size.norm() + m_size.norm() * g.norm()));
            }
            CHECK(worst < twin_tolerance(precision));
            CHECK(wrong == 0);
            CHECK(undefined < p.size() / 4);
        });
    });
}

TEMPLATE_TEST_CASE_SIG("density diffusion far from the origin, at any scale, on any number of threads",
                       "[density_diffusion]", ((int Dim), Dim), 2, 3) {
    const auto check = [](const Particles<Dim>& p, double spacing) {
        const NeighborList list = list_of(p);
        const auto gradient = random_vectors<Dim>(p.size(), 200 / spacing);
        const auto expected = twin::diffusive_continuity<Dim>(p, delta * c0, [&](std::size_t i, std::size_t j) {
            return expected_difference<Dim>(p, gradient, DensityDiffusion::antuono, i, j);
        });
        in_all_variants([&](Precision precision) {
            const auto rates = [&](int threads) {
                const ThreadScope scope(threads);
                ScalarField rate(p.size(), 0.0);
                diffusive_continuity<Dim>(view_with(p, gradient), list, terms_of<Dim>(DensityDiffusion::antuono),
                                          precision, rate);
                return rate;
            };
            const ScalarField rate = rates(1);
            CHECK(worst_error(rate, expected) < twin_tolerance(precision));
            CHECK((rates(2) == rate));
        });
    };
    auto far = make_scene<Dim>(Scene::unequal);
    for (auto& column : far.position.c)
        for (double& x : column) x += 1e4;  // [m]; a float's grid there is 1e-3 m, a spacing is 0.1 m
    check(far, 0.1);
    for (const double scale : scales) {
        auto p = make_scene<Dim>(Scene::odd);
        rescale(p, scale);
        CAPTURE(scale);
        check(p, 0.1 * scale);
    }
}

TEMPLATE_TEST_CASE_SIG("without a coefficient there is no diffusion", "[density_diffusion]", ((int Dim), Dim), 2, 3) {
    const auto p = make_scene<Dim>(Scene::jittered);
    const NeighborList list = list_of(p);
    ScalarField plain(p.size(), 0.0), none(p.size(), 0.0), zero(p.size(), 0.0);
    continuity<Dim>(p.view(), list, Precision::full, plain);
    diffusive_continuity<Dim>(p.view(), list, {}, Precision::full, none);
    diffusive_continuity<Dim>(p.view(), list, {DensityDiffusion::molteni_colagrossi, c0, 0, rho0, {}}, Precision::full,
                              zero);
    CHECK((none == plain));
    CHECK((zero == plain));
}

TEMPLATE_TEST_CASE_SIG("density diffusion keeps the sum of V dρ/dt", "[density_diffusion]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(3, [](const auto& p, const NeighborList& list) {
        in_all_variants([&](Precision precision) {
            for (const DensityDiffusion kind : kinds) {
                const ScalarField rate = diffusion_rates<Dim>(p, list, kind, precision);
                double sum = 0, size = 0;
                for (std::size_t i = 0; i < p.size(); ++i) {
                    sum += p.volume[i] * rate[i];
                    size += p.volume[i] * std::abs(rate[i]);
                }
                CAPTURE(static_cast<int>(kind));
                // As the momentum of pair forces: what both sides of a pair round differently.
                CHECK(std::abs(sum) < (precision == Precision::full ? 1e-12 : 1e-5) * size);
            }
        });
    });
}

TEMPLATE_TEST_CASE_SIG("a uniform density does not diffuse", "[density_diffusion]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(4, [](auto p, const NeighborList& list) {
        std::fill(p.density.begin(), p.density.end(), rho0 + 0.1);
        in_all_variants([&](Precision precision) {
            const ScalarField none(p.size(), 0.0);  // differences of equal numbers: exactly
            CHECK((diffusion_rates<Dim>(p, list, DensityDiffusion::molteni_colagrossi, precision) == none));
            CHECK((diffusion_rates<Dim>(p, list, DensityDiffusion::antuono, precision) == none));
        });
    });
}

TEMPLATE_TEST_CASE_SIG(
    "a fluid at rest under gravity does not diffuse by Fourtakas et al., surfaces and walls included",
    "[density_diffusion]", ((int Dim), Dim), 2, 3) {
    const auto p = stratified<Dim>((rho0 / (c0 * c0)) * gravity<Dim>());
    const NeighborList list = list_of(p);
    const double with = largest(diffusion_rates<Dim>(p, list, DensityDiffusion::fourtakas)),
                 without = largest(diffusion_rates<Dim>(p, list, DensityDiffusion::molteni_colagrossi));
    // Densities of 1000 differ by some 0.5 between neighbours: eps 1000/0.5 = 4e-13, and the sum's.
    CHECK(with < 1e-11 * without);
}

TEMPLATE_TEST_CASE_SIG("Tait's fluid at rest keeps a twentieth of its diffusion by Fourtakas et al.",
                       "[density_diffusion]", ((int Dim), Dim), 2, 3) {
    // Depth H with c0² = 100 g H: ρ(z) = ρ0 (1 + (γ−1) g z/c0²)^(1/(γ−1)), from dp = ρ g dz.
    const auto at_rest = [](double depth) { return rho0 * std::pow(1 + 6 * 0.01 * depth, 1.0 / 6); };
    auto p = lattice(cube<Dim>(Dim == 2 ? 20 : 10, Dim == 2 ? 0.05 : 0.1, 1.5));  // H = 1 m
    for (std::size_t i = 0; i < p.size(); ++i) p.density[i] = at_rest(1 - p.position[i][1]);
    DiffusionTerms<Dim> terms = terms_of<Dim>(DensityDiffusion::fourtakas);
    terms.gravity = {};
    terms.gravity[1] = -0.01 * c0 * c0;
    const NeighborList list = list_of(p);
    for (auto& column : p.velocity.c) std::fill(column.begin(), column.end(), 0.0);
    ScalarField with(p.size(), 0.0), without(p.size(), 0.0);
    diffusive_continuity<Dim>(p.view(), list, terms, Precision::full, with);
    terms.kind = DensityDiffusion::molteni_colagrossi;
    diffusive_continuity<Dim>(p.view(), list, terms, Precision::full, without);
    CHECK(largest(with) < 0.05 * largest(without));  // (γ − 2) g H/c0² at the bottom
}

TEMPLATE_TEST_CASE_SIG("no linear density diffuses by Antuono et al., surfaces included", "[density_diffusion]",
                       ((int Dim), Dim), 2, 3) {
    const auto p = stratified<Dim>(random_vectors<Dim>(1, 50)[0]);
    const NeighborList list = list_of(p);
    const double with = largest(diffusion_rates<Dim>(p, list, DensityDiffusion::antuono)),
                 without = largest(diffusion_rates<Dim>(p, list, DensityDiffusion::molteni_colagrossi));
    CHECK(with < 1e-10 * without);  // as above, times the condition of M at a corner
}

TEMPLATE_TEST_CASE_SIG("a density wave decays at the rate of the diffusion equation", "[density_diffusion]",
                       ((int Dim), Dim), 2, 3) {
    // The lattice's own error at h/d = 1.5, +0.7 and +1.0 %, and that of a wave of kh = 0.24 or 0.39, about −(kh)²/12.
    const int n = Dim == 2 ? 40 : 24;
    CHECK(wave_damping<Dim>(DensityDiffusion::molteni_colagrossi, n) == Approx(1).epsilon(0.005));
}

TEMPLATE_TEST_CASE_SIG("by Antuono et al. a long wave decays with the fourth power of its number",
                       "[density_diffusion]", ((int Dim), Dim), 2) {
    // What a linear field leaves over of ρ_j − ρ_i is −(x_ji·∇)³ρ/12: the rate is of order δ c0 h³ ∇⁴ρ.
    const double coarse = wave_damping<Dim>(DensityDiffusion::antuono, 24),
                 fine = wave_damping<Dim>(DensityDiffusion::antuono, 48);
    CHECK(coarse > 0);
    CAPTURE(coarse, fine);
    CHECK(coarse / fine == Approx(4).epsilon(0.1));  // the next order is (kh)²/8 of the first, kh = 0.4
}

TEMPLATE_TEST_CASE_SIG("density diffusion damps what differs from one particle to the next", "[density_diffusion]",
                       ((int Dim), Dim), 2, 3) {
    const int n = Dim == 2 ? 16 : 10;
    auto p = lattice(cube<Dim>(n, 0.1, 1.5));
    const auto sign = [&](std::size_t i) {
        int cells = 0;
        for (int k = 0; k < Dim; ++k) cells += static_cast<int>(p.position[i][k] / 0.1);
        return cells % 2 == 0 ? 1 : -1;
    };
    for (std::size_t i = 0; i < p.size(); ++i) p.density[i] = rho0 + sign(i);
    const NeighborList list = list_of(p);
    for (const DensityDiffusion kind : kinds) {
        const ScalarField rate = diffusion_rates<Dim>(p, list, kind);
        std::size_t growing = 0;
        for (std::size_t i = 0; i < p.size(); ++i) growing += rate[i] * sign(i) >= 0;
        CAPTURE(static_cast<int>(kind));
        CHECK(growing == 0);
    }
}

}  // namespace sluice::test_density_diffusion
