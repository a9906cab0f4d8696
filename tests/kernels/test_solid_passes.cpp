// The solid's pair passes against their plain twins.
#include "kernels/solid_passes.hpp"

#include "kernels/tensor.hpp"
#include "neighbor/parallel.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"

using namespace sluice;

namespace {

/// Eq. (15) held against G = L M: the residual, in units of what rounding G, M and the sums may cost. Particles
/// without enough neighbours must have L = 0. Returns infinity if that rule is broken.
template <int Dim>
double gradient_residual(const TupleField<Dim * Dim>& l, const twin::Sums<2 * Dim * Dim>& sums) {
    constexpr int N = Dim * Dim;
    double worst = 0;
    for (std::size_t i = 0; i < l.size(); ++i) {
        Tensor<Dim> gradient, g, m, g_size, m_size;
        for (int k = 0; k < N; ++k) {
            gradient(k / Dim, k % Dim) = l[i][k];
            g(k / Dim, k % Dim) = sums.value[i][k];
            m(k / Dim, k % Dim) = sums.value[i][N + k];
            g_size(k / Dim, k % Dim) = sums.magnitude[i][k];
            m_size(k / Dim, k % Dim) = sums.magnitude[i][N + k];
        }
        if (std::abs(m.determinant() - 1e-3) < 1e-5) continue;  // on the threshold rounding decides
        if (m.determinant() < 1e-3) {
            if (gradient != Tensor<Dim>::Zero()) return std::numeric_limits<double>::infinity();
            continue;
        }
        const double scale = g_size.norm() + gradient.norm() * m_size.norm();
        worst = std::max(worst, relative_error((gradient * m - g).norm(), 0, scale));
    }
    return worst;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("solid_momentum equals its twin", "[solid]", ((int Dim, class Real), Dim, Real), (2, double),
                       (2, float), (3, double), (3, float)) {
    for (const Scene scene : scenes)
        for (const double alpha : {0.0, 1.0})
            for (const double e : {0.0, 0.3}) {
                const auto p = make_scene<Dim>(scene);
                const auto expected = twin::solid_momentum<Dim>(p, {alpha, 134.8, e > 0, 4, 1.3});
                for (const int group_size : {1, 8}) {
                    auto a = zeros<Dim>(p.size());
                    solid_momentum<Dim, Real>(p.view(), list_of(p, group_size), {alpha, 134.8, e, 4, 1.3}, a);
                    CAPTURE(static_cast<int>(scene), alpha, e, group_size);
                    CHECK(worst_error(a, expected) < twin_tolerance<Real>);
                }
            }
}

TEMPLATE_TEST_CASE_SIG("the artificial stress takes any exponent", "[solid]", ((int Dim, class Real), Dim, Real),
                       (2, double), (2, float), (3, double), (3, float)) {
    const auto p = make_scene<Dim>(Scene::unequal);
    for (int q = 1; q <= 8; ++q) {
        const auto expected = twin::solid_momentum<Dim>(p, {0, 0, true, q, 1.5});
        auto a = zeros<Dim>(p.size());
        solid_momentum<Dim, Real>(p.view(), list_of(p), {0, 0, 0.3, q, 1.5}, a);
        CAPTURE(q);
        CHECK(worst_error(a, expected) < twin_tolerance<Real>);
    }
}

TEMPLATE_TEST_CASE_SIG("solid_rates equals its twin", "[solid]", ((int Dim, class Real), Dim, Real), (2, double),
                       (2, float), (3, double), (3, float)) {
    for (const Scene scene : scenes) {
        const auto p = make_scene<Dim>(scene);
        const auto density = twin::continuity<Dim>(p);
        const auto sums = twin::gradient_sums<Dim>(p);
        for (const int group_size : {1, 8}) {
            ScalarField rate(p.size(), 0.0);
            auto l = zeros<Dim * Dim>(p.size());
            solid_rates<Dim, Real>(p.view(), list_of(p, group_size), rate, l);
            CAPTURE(static_cast<int>(scene), group_size);
            CHECK(worst_error(rate, density) < twin_tolerance<Real>);
            CHECK(gradient_residual<Dim>(l, sums) < twin_tolerance<Real>);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("too few neighbours give no velocity gradient", "[solid]", ((int Dim), Dim), 2, 3) {
    // A pair and a row: M is singular, whatever the velocities.
    for (const int n : {2, 6}) {
        Particles<Dim> p;
        for (int i = 0; i < n; ++i) {
            Vec<Dim> x;
            x[0] = 0.1 * i;
            p.add(x, 0.15, 1000 * std::pow(0.1, Dim), 1000);
            p.velocity.set(static_cast<std::size_t>(i), (1.0 * i) * x);
        }
        ScalarField rate(p.size(), 0.0);
        auto l = zeros<Dim * Dim>(p.size());
        for (auto& column : l.c) column.assign(p.size(), 9.0);
        solid_rates<Dim, double>(p.view(), list_of(p), rate, l);
        CHECK(same_bits(l, zeros<Dim * Dim>(p.size())));
    }
}

TEMPLATE_TEST_CASE_SIG("a lone particle has no velocity gradient of an earlier list", "[solid]", ((int Dim), Dim), 2,
                       3) {
    auto p = lattice(cube<Dim>(3, 0.1, 1.5));
    Vec<Dim> away;
    away[0] = 50;
    p.add(away, 0.15, 1, 1000);
    ScalarField rate(p.size(), 0.0);
    auto l = zeros<Dim * Dim>(p.size());
    for (auto& column : l.c) column.assign(p.size(), 9.0);
    solid_rates<Dim, double>(p.view(), list_of(p), rate, l);
    CHECK(l[p.size() - 1] == Vec<Dim * Dim>{});
}

TEMPLATE_TEST_CASE_SIG("solid passes have the same bits for any number of threads", "[solid]",
                       ((int Dim, class Real), Dim, Real), (2, double), (2, float), (3, double), (3, float)) {
    const auto p = make_scene<Dim>(Scene::unequal);
    const NeighborList list = list_of(p);
    REQUIRE(list.size() > parallel_threshold);
    std::vector<VectorField<Dim>> momentum;
    std::vector<TupleField<Dim * Dim>> gradients;
    std::vector<ScalarField> rates;
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        auto a = zeros<Dim>(p.size());
        auto l = zeros<Dim * Dim>(p.size());
        ScalarField rate(p.size(), 0.0);
        solid_momentum<Dim, Real>(p.view(), list, {1, 134.8, 0.3, 4, 1.3}, a);
        solid_rates<Dim, Real>(p.view(), list, rate, l);
        momentum.push_back(a);
        gradients.push_back(l);
        rates.push_back(rate);
    }
    for (const std::size_t t : {1, 2}) {
        CHECK(same_bits(momentum[t], momentum[0]));
        CHECK(same_bits(gradients[t], gradients[0]));
        CHECK((rates[t] == rates[0]));
    }
}
