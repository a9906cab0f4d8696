// The solid's pair passes against their plain twins.
#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/solid_passes.hpp"

#include "kernels/tensor.hpp"
#include "neighbor/parallel.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"

namespace sluice::test_solid_passes {

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

/// Momentum with all its terms, density rate and gradient on one set, all against their twins.
template <int Dim>
void check_all_passes(const Particles<Dim>& p, const NeighborList& list) {
    const auto momentum = twin::solid_momentum<Dim>(p, {1, 134.8, true, 4, 1.3});
    const auto density = twin::continuity<Dim>(p);
    const auto sums = twin::gradient_sums<Dim>(p);
    in_all_variants([&](Precision precision) {
        auto a = zeros<Dim>(p.size());
        ScalarField rate(p.size(), 0.0);
        auto l = zeros<Dim * Dim>(p.size());
        solid_momentum<Dim>(p.view(), list, {1, 134.8, 0.3, 4, 1.3}, precision, a);
        solid_rates<Dim>(p.view(), list, precision, rate, l);
        CHECK(worst_error(a, momentum) < twin_tolerance(precision));
        CHECK(worst_error(rate, density) < twin_tolerance(precision));
        CHECK(gradient_residual<Dim>(l, sums) < twin_tolerance(precision));
    });
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("solid_momentum equals its twin", "[solid]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) {
        for (const double alpha : {0.0, 1.0})
            for (const double e : {0.0, 0.3}) {
                const auto expected = twin::solid_momentum<Dim>(p, {alpha, 134.8, e > 0, 4, 1.3});
                in_all_variants([&](Precision precision) {
                    auto a = zeros<Dim>(p.size());
                    const auto pairs = solid_momentum<Dim>(p.view(), list, {alpha, 134.8, e, 4, 1.3}, precision, a);
                    CAPTURE(alpha, e);
                    CHECK(worst_error(a, expected) < twin_tolerance(precision));
                    CHECK(pairs == list.pairs());
                });
            }
    });
}

TEMPLATE_TEST_CASE_SIG("the artificial stress takes any exponent", "[solid]", ((int Dim), Dim), 2, 3) {
    const auto p = make_scene<Dim>(Scene::unequal);
    const NeighborList list = list_of(p);
    for (int q = 1; q <= 8; ++q) {
        const auto expected = twin::solid_momentum<Dim>(p, {0, 0, true, q, 1.5});
        in_all_variants([&](Precision precision) {
            auto a = zeros<Dim>(p.size());
            solid_momentum<Dim>(p.view(), list, {0, 0, 0.3, q, 1.5}, precision, a);
            CAPTURE(q);
            CHECK(worst_error(a, expected) < twin_tolerance(precision));
        });
    }
}

TEMPLATE_TEST_CASE_SIG("solid_rates equals its twin", "[solid]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) {
        const auto density = twin::continuity<Dim>(p);
        const auto sums = twin::gradient_sums<Dim>(p);
        in_all_variants([&](Precision precision) {
            ScalarField rate(p.size(), 0.0);
            auto l = zeros<Dim * Dim>(p.size());
            solid_rates<Dim>(p.view(), list, precision, rate, l);
            CHECK(worst_error(rate, density) < twin_tolerance(precision));
            CHECK(gradient_residual<Dim>(l, sums) < twin_tolerance(precision));
        });
    });
}

TEMPLATE_TEST_CASE_SIG("the solid's passes over rows of several parts", "[solid]", ((int Dim), Dim), 2, 3) {
    // More clusters within one support than a byte can number.
    Random random(5);
    Particles<Dim> p;
    for (int i = 0; i < 1200; ++i) p.add(random.vector<Dim>(0, 0.1), random.in(0.1, 0.15), 1, 1000);
    randomize_state(p, random);
    check_all_passes(p, list_of(p));
}

TEMPLATE_TEST_CASE_SIG("the solid's passes far from the origin", "[solid]", ((int Dim), Dim), 2, 3) {
    for (const Layout layout : layouts) {
        auto p = make_scene<Dim>(Scene::unequal, 1, layout);
        for (auto& column : p.position.c)
            for (double& x : column) x += 1e4;  // [m]; a float's grid there is 1e-3 m, a spacing is 0.1 m
        CAPTURE(layout == Layout::sorted);
        check_all_passes(p, list_of(p));
    }
}

TEMPLATE_TEST_CASE_SIG("the solid's passes at any scale", "[solid]", ((int Dim), Dim), 2, 3) {
    for (const double scale : scales) {
        auto p = make_scene<Dim>(Scene::odd);
        rescale(p, scale);
        CAPTURE(scale);
        check_all_passes(p, list_of(p));
    }
}

TEMPLATE_TEST_CASE_SIG("too few neighbours give no velocity gradient", "[solid]", ((int Dim), Dim), 2, 3) {
    // One, a pair, and a row: M is singular, whatever the velocities.
    for (const int n : {1, 2, 6}) {
        Particles<Dim> p;
        for (int i = 0; i < n; ++i) {
            Vec<Dim> x;
            x[0] = 0.1 * i;
            p.add(x, 0.15, 1000 * std::pow(0.1, Dim), 1000);
            p.velocity.set(static_cast<std::size_t>(i), (1.0 * i) * x);
        }
        const NeighborList list = list_of(p);
        in_all_variants([&](Precision precision) {
            ScalarField rate(p.size(), 0.0);
            auto l = zeros<Dim * Dim>(p.size());
            for (auto& column : l.c) column.assign(p.size(), 9.0);
            solid_rates<Dim>(p.view(), list, precision, rate, l);
            CHECK(same_bits(l, zeros<Dim * Dim>(p.size())));
        });
    }
}

TEMPLATE_TEST_CASE_SIG("a lone particle has no velocity gradient of an earlier list", "[solid]", ((int Dim), Dim), 2,
                       3) {
    auto p = lattice(cube<Dim>(3, 0.1, 1.5));
    Vec<Dim> away;
    away[0] = 50;
    p.add(away, 0.15, 1, 1000);
    const NeighborList list = list_of(p);
    in_all_variants([&](Precision precision) {
        ScalarField rate(p.size(), 0.0);
        auto l = zeros<Dim * Dim>(p.size());
        for (auto& column : l.c) column.assign(p.size(), 9.0);
        solid_rates<Dim>(p.view(), list, precision, rate, l);
        CHECK(l[p.size() - 1] == Vec<Dim * Dim>{});
    });
}

TEMPLATE_TEST_CASE_SIG("solid passes have the same bits for any number of threads", "[solid]", ((int Dim), Dim), 2, 3) {
    const auto p = make_scene<Dim>(Scene::unequal);
    const NeighborList list = list_of(p);
    REQUIRE(list.cluster_pairs() > parallel_cluster_pairs);
    in_all_variants([&](Precision precision) {
        std::vector<VectorField<Dim>> momentum;
        std::vector<TupleField<Dim * Dim>> gradients;
        std::vector<ScalarField> rates;
        for (const int threads : {1, 2, 4}) {
            const ThreadScope scope(threads);
            auto a = zeros<Dim>(p.size());
            auto l = zeros<Dim * Dim>(p.size());
            ScalarField rate(p.size(), 0.0);
            solid_momentum<Dim>(p.view(), list, {1, 134.8, 0.3, 4, 1.3}, precision, a);
            solid_rates<Dim>(p.view(), list, precision, rate, l);
            momentum.push_back(a);
            gradients.push_back(l);
            rates.push_back(rate);
        }
        for (const std::size_t t : {1, 2}) {
            CHECK(same_bits(momentum[t], momentum[0]));
            CHECK(same_bits(gradients[t], gradients[0]));
            CHECK((rates[t] == rates[0]));
        }
    });
}

}  // namespace sluice::test_solid_passes
