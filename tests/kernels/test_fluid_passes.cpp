// The fluid's pair passes against their plain twins.
#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/fluid_passes.hpp"

#include "neighbor/parallel.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"

namespace sluice::test_fluid_passes {

namespace {

/// (1 − θ) times the quotient of the filter's two sums.
template <int Dim>
twin::Sums<Dim> filter_correction(const Particles<Dim>& p, double theta) {
    const auto sums = twin::filter_sums<Dim>(p);
    twin::Sums<Dim> expected{std::vector<Vec<Dim>>(p.size()), std::vector<Vec<Dim>>(p.size())};
    for (std::size_t i = 0; i < p.size(); ++i)
        for (int k = 0; k < Dim; ++k) {
            expected.value[i][k] = (1 - theta) * sums.value[i][k] / sums.value[i][Dim];
            expected.magnitude[i][k] = (1 - theta) * sums.magnitude[i][k] / sums.value[i][Dim];
        }
    return expected;
}

/// Both rates and the filter on one set, all against their twins.
template <int Dim>
void check_all_passes(const Particles<Dim>& p, const NeighborList& list) {
    const auto momentum = twin::fluid_momentum<Dim>(p, 0.5, 30);
    const auto rates = twin::continuity<Dim>(p);
    const auto filter = filter_correction(p, 0.92);
    in_all_variants([&](Precision precision) {
        auto a = zeros<Dim>(p.size()), correction = zeros<Dim>(p.size());
        ScalarField rate(p.size(), 0.0);
        fluid_momentum<Dim>(p.view(), list, {0.5, 30}, precision, a);
        continuity<Dim>(p.view(), list, precision, rate);
        velocity_filter<Dim>(p.view(), list, 0.92, precision, correction);
        CHECK(worst_error(a, momentum) < twin_tolerance(precision));
        CHECK(worst_error(rate, rates) < twin_tolerance(precision));
        CHECK(worst_error(correction, filter) < twin_tolerance(precision));
    });
}

/// A row of particles at the given places on the x axis.
template <int Dim>
Particles<Dim> row(std::initializer_list<double> places, double h) {
    Particles<Dim> p;
    for (const double x : places) {
        Vec<Dim> at;
        at[0] = x;
        p.add(at, h, 1000, 1000);
    }
    return p;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("fluid_momentum equals its twin", "[fluid]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) {
        for (const double alpha : {0.0, 0.7}) {
            const auto expected = twin::fluid_momentum<Dim>(p, alpha, 30);
            in_all_variants([&](Precision precision) {
                auto a = zeros<Dim>(p.size());
                const auto pairs = fluid_momentum<Dim>(p.view(), list, {alpha, 30}, precision, a);
                CAPTURE(alpha);
                CHECK(worst_error(a, expected) < twin_tolerance(precision));
                CHECK(pairs == list.pairs());
            });
        }
    });
}

TEMPLATE_TEST_CASE_SIG("continuity equals its twin", "[fluid]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) {
        const auto expected = twin::continuity<Dim>(p);
        in_all_variants([&](Precision precision) {
            ScalarField rate(p.size(), 0.0);
            const auto pairs = continuity<Dim>(p.view(), list, precision, rate);
            CHECK(worst_error(rate, expected) < twin_tolerance(precision));
            CHECK(pairs == list.pairs());
        });
    });
}

TEMPLATE_TEST_CASE_SIG("velocity_filter equals its twin", "[fluid]", ((int Dim), Dim), 2, 3) {
    in_all_scenes<Dim>(1, [](const auto& p, const NeighborList& list) {
        const auto expected = filter_correction(p, 0.92);
        in_all_variants([&](Precision precision) {
            auto correction = zeros<Dim>(p.size());
            velocity_filter<Dim>(p.view(), list, 0.92, precision, correction);
            CHECK(worst_error(correction, expected) < twin_tolerance(precision));
        });
    });
}

TEMPLATE_TEST_CASE_SIG("the scenes have full clusters and others, runs of memory and others", "[fluid]",
                       ((int Dim), Dim), 2, 3) {
    for (const Layout layout : layouts) {
        std::size_t full = 0, partial = 0, runs = 0, indexed = 0, unequal = 0;
        const auto p = make_scene<Dim>(Scene::unequal, 1, layout);
        const NeighborList list = list_of(p);
        for (std::size_t b = 0; b < list.blocks(); ++b)
            for (Index q = list.view().block[b].queries.begin; q < list.view().block[b].queries.end; ++q) {
                const ListedCluster& c = list.view().query[q];
                (c.size == cluster_size ? full : partial) += 1;
                if (c.size > 1) (c.in_sequence ? runs : indexed) += 1;
                unequal += !list.view().equal_reach[q];
            }
        CHECK(full > 20);
        CHECK(partial > 20);
        CHECK(unequal > 20);
        CHECK((layout == Layout::sorted ? indexed : runs) == 0);
        CHECK((layout == Layout::sorted ? runs : indexed) > 20);
    }
}

TEMPLATE_TEST_CASE_SIG("the fluid's passes over rows of several parts", "[fluid]", ((int Dim), Dim), 2, 3) {
    // More clusters within one support than a byte can number.
    Random random(5);
    Particles<Dim> p;
    for (int i = 0; i < 1200; ++i) p.add(random.vector<Dim>(0, 0.1), random.in(0.1, 0.15), 1, 1000);
    randomize_state(p, random);
    const NeighborList list = list_of(p);
    std::size_t several = 0;
    for (std::size_t b = 0; b < list.blocks(); ++b) several += list.view().block[b].parts.size() > 1;
    REQUIRE(several > 0);
    check_all_passes(p, list);
}

TEMPLATE_TEST_CASE_SIG("the fluid's passes far from the origin", "[fluid]", ((int Dim), Dim), 2, 3) {
    for (const Layout layout : layouts) {
        auto p = make_scene<Dim>(Scene::unequal, 1, layout);
        for (auto& column : p.position.c)
            for (double& x : column) x += 1e4;  // [m]; a float's grid there is 1e-3 m, a spacing is 0.1 m
        CAPTURE(layout == Layout::sorted);
        check_all_passes(p, list_of(p));
    }
}

TEMPLATE_TEST_CASE_SIG("the fluid's passes at any scale", "[fluid]", ((int Dim), Dim), 2, 3) {
    for (const double scale : scales) {
        auto p = make_scene<Dim>(Scene::odd);
        rescale(p, scale);
        CAPTURE(scale);
        check_all_passes(p, list_of(p));
    }
}

TEMPLATE_TEST_CASE_SIG("the filter leaves a stray particle as it is", "[fluid]", ((int Dim), Dim), 2, 3) {
    // Two particles just beyond each other's support, but within the list's skin, and a third out of everybody's reach.
    auto p = row<Dim>({0, 2.1, 50}, 1);
    p.velocity.c[0] = {1, -1, 3};
    const NeighborList list = list_of(p);
    REQUIRE(list.size() == 3);
    REQUIRE(list.pairs() == 0);
    REQUIRE(list.cluster_pairs() == 2);  // the two with themselves, and the third
    in_all_variants([&](Precision precision) {
        auto correction = zeros<Dim>(p.size());
        for (auto& column : correction.c) column.assign(p.size(), 7.0);  // of an earlier step
        velocity_filter<Dim>(p.view(), list, 0.92, precision, correction);
        CHECK(same_bits(correction, zeros<Dim>(p.size())));
    });
}

TEMPLATE_TEST_CASE_SIG("a particle feels nothing of itself, nor of another at its place", "[fluid]", ((int Dim), Dim),
                       2, 3) {
    for (const std::initializer_list<double> places : {std::initializer_list<double>{0.3}, {0.3, 0.3, 0.3}}) {
        auto p = row<Dim>(places, 0.1);
        Random random(3);
        randomize_state(p, random);
        const NeighborList list = list_of(p);
        REQUIRE(list.size() == p.size());
        REQUIRE(list.pairs() == p.size() * (p.size() - 1));
        in_all_variants([&](Precision precision) {
            auto a = zeros<Dim>(p.size());
            ScalarField rate(p.size(), 0.0);
            fluid_momentum<Dim>(p.view(), list, {1, 30}, precision, a);
            continuity<Dim>(p.view(), list, precision, rate);
            CHECK(same_bits(a, zeros<Dim>(p.size())));
            CHECK((rate == ScalarField(p.size(), 0.0)));
        });
    }
}

TEMPLATE_TEST_CASE_SIG("a pass adds to what is there, for listed particles only", "[fluid]", ((int Dim), Dim), 2, 3) {
    const auto p = make_scene<Dim>(Scene::jittered);
    const std::size_t owned = 300;
    ClusterGrid<Dim> own, others;
    own.build(p.position, 0, owned, cell_for(p.h), p.h);
    others.build(p.position, owned, p.size(), cell_for(p.h), p.h);
    const ClusterGrid<Dim>* const targets[] = {&own, &others};
    NeighborList list;
    NeighborSearch<Dim> searcher;
    searcher.build(own, targets, {}, list);
    searcher.prune({p.position, p.h}, {p.position, p.h}, {}, list);
    REQUIRE(list.size() == owned);
    const auto expected = twin::fluid_momentum<Dim>(p, 0, 30);
    const auto rates = twin::continuity<Dim>(p);
    in_all_variants([&](Precision precision) {
        auto once = zeros<Dim>(p.size()), onto = zeros<Dim>(p.size());
        for (auto& column : onto.c) column.assign(p.size(), 5.0);
        fluid_momentum<Dim>(p.view(), list, {}, precision, once);
        fluid_momentum<Dim>(p.view(), list, {}, precision, onto);
        ScalarField rate(p.size(), 5.0);
        continuity<Dim>(p.view(), list, precision, rate);
        const auto scale = error_scale(expected), rate_scale = error_scale(rates);
        std::size_t wrong = 0;
        double worst = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            for (int k = 0; k < Dim; ++k) {
                const double sum = i < owned ? expected.value[i][k] : 0;
                wrong += onto[i][k] != 5.0 + once[i][k];
                worst = std::max(worst, relative_error(once[i][k], sum, scale[i]));
            }
            worst = std::max(worst, relative_error(rate[i], 5 + (i < owned ? rates.value[i][0] : 0), rate_scale[i]));
            wrong += i >= owned && rate[i] != 5;
        }
        CHECK(wrong == 0);
        CHECK(worst < twin_tolerance(precision));
    });
}

TEMPLATE_TEST_CASE_SIG("fluid passes over nothing do nothing", "[fluid]", ((int Dim), Dim), 2, 3) {
    const Particles<Dim> none;
    const NeighborList list = list_of(none);
    in_all_variants([&](Precision precision) {
        auto a = zeros<Dim>(0);
        ScalarField rate;
        CHECK(fluid_momentum<Dim>(none.view(), list, {1, 30}, precision, a) == 0);
        CHECK(continuity<Dim>(none.view(), list, precision, rate) == 0);
        CHECK(velocity_filter<Dim>(none.view(), list, 0.92, precision, a) == 0);
    });
}

TEMPLATE_TEST_CASE_SIG("fluid passes have the same bits for any number of threads", "[fluid]", ((int Dim), Dim), 2, 3) {
    const auto p = make_scene<Dim>(Scene::unequal);
    const NeighborList list = list_of(p);
    REQUIRE(list.cluster_pairs() > parallel_cluster_pairs);
    in_all_variants([&](Precision precision) {
        std::vector<VectorField<Dim>> momentum, filter;
        std::vector<ScalarField> rates;
        for (const int threads : {1, 2, 4}) {
            const ThreadScope scope(threads);
            auto a = zeros<Dim>(p.size()), correction = zeros<Dim>(p.size());
            ScalarField rate(p.size(), 0.0);
            fluid_momentum<Dim>(p.view(), list, {0.5, 30}, precision, a);
            velocity_filter<Dim>(p.view(), list, 0.92, precision, correction);
            continuity<Dim>(p.view(), list, precision, rate);
            momentum.push_back(a);
            filter.push_back(correction);
            rates.push_back(rate);
        }
        for (const std::size_t t : {1, 2}) {
            CHECK(same_bits(momentum[t], momentum[0]));
            CHECK(same_bits(filter[t], filter[0]));
            CHECK((rates[t] == rates[0]));
        }
    });
}

}  // namespace sluice::test_fluid_passes
