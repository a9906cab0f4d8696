// The fluid's pair passes against their plain twins.
#include "kernels/fluid_passes.hpp"

#include "kernels/tile.hpp"
#include "neighbor/parallel.hpp"
#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"

using namespace sluice;

TEMPLATE_TEST_CASE_SIG("the crowded scene has more candidates than a tile", "[fluid]", ((int Dim), Dim), 2, 3) {
    const auto p = make_scene<Dim>(Scene::crowded);
    CHECK(largest_group<Dim>(list_of(p, 1)) > tile_capacity);
    CHECK(largest_group<Dim>(list_of(p, 8)) > 2 * tile_capacity);
}

TEMPLATE_TEST_CASE_SIG("fluid_momentum equals its twin", "[fluid]", ((int Dim, class Real), Dim, Real), (2, double),
                       (2, float), (3, double), (3, float)) {
    for (const Scene scene : scenes)
        for (const double alpha : {0.0, 0.7}) {
            const auto p = make_scene<Dim>(scene);
            const auto expected = twin::fluid_momentum<Dim>(p, alpha, 30);
            for (const int group_size : {1, 8}) {
                const NeighborList list = list_of(p, group_size);
                auto a = zeros<Dim>(p.size());
                const auto pairs = fluid_momentum<Dim, Real>(p.view(), list, {alpha, 30}, a);
                CAPTURE(static_cast<int>(scene), alpha, group_size);
                CHECK(worst_error(a, expected) < twin_tolerance<Real>);
                CHECK(pairs == list.pairs());
            }
        }
}

TEMPLATE_TEST_CASE_SIG("continuity equals its twin", "[fluid]", ((int Dim, class Real), Dim, Real), (2, double),
                       (2, float), (3, double), (3, float)) {
    for (const Scene scene : scenes) {
        const auto p = make_scene<Dim>(scene);
        const auto expected = twin::continuity<Dim>(p);
        for (const int group_size : {1, 8}) {
            ScalarField rate(p.size(), 0.0);
            continuity<Dim, Real>(p.view(), list_of(p, group_size), rate);
            CAPTURE(static_cast<int>(scene), group_size);
            CHECK(worst_error(rate, expected) < twin_tolerance<Real>);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("velocity_filter equals its twin", "[fluid]", ((int Dim, class Real), Dim, Real), (2, double),
                       (2, float), (3, double), (3, float)) {
    const double theta = 0.92;
    for (const Scene scene : scenes) {
        const auto p = make_scene<Dim>(scene);
        const auto sums = twin::filter_sums<Dim>(p);
        twin::Sums<Dim> expected{std::vector<Vec<Dim>>(p.size()), std::vector<Vec<Dim>>(p.size())};
        for (std::size_t i = 0; i < p.size(); ++i)
            for (int k = 0; k < Dim; ++k) {
                expected.value[i][k] = (1 - theta) * sums.value[i][k] / sums.value[i][Dim];
                expected.magnitude[i][k] = (1 - theta) * sums.magnitude[i][k] / sums.value[i][Dim];
            }
        for (const int group_size : {2, 8}) {
            auto correction = zeros<Dim>(p.size());
            velocity_filter<Dim, Real>(p.view(), list_of(p, group_size), theta, correction);
            CAPTURE(static_cast<int>(scene), group_size);
            CHECK(worst_error(correction, expected) < twin_tolerance<Real>);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("the filter leaves a stray particle as it is", "[fluid]", ((int Dim, class Real), Dim, Real),
                       (2, double), (2, float), (3, double), (3, float)) {
    // Two particles just beyond each other's support, but within the list's skin, and a third out of everybody's reach.
    Particles<Dim> p;
    for (const double x : {0.0, 2.1, 50.0}) {
        Vec<Dim> at;
        at[0] = x;
        p.add(at, 1, 1000, 1000);
    }
    p.velocity.c[0] = {1, -1, 3};
    auto correction = zeros<Dim>(p.size());
    for (auto& column : correction.c) column.assign(p.size(), 7.0);  // of an earlier step
    const NeighborList list = list_of(p);
    REQUIRE(list.size() == 3);
    REQUIRE(list.pairs() == 0);
    velocity_filter<Dim, Real>(p.view(), list, 0.92, correction);
    CHECK(same_bits(correction, zeros<Dim>(p.size())));
}

TEMPLATE_TEST_CASE_SIG("a pass adds to what is there, for listed particles only", "[fluid]", ((int Dim), Dim), 2, 3) {
    auto p = make_scene<Dim>(Scene::jittered);
    Vec<Dim> away;
    away[0] = 100;
    p.add(away, 0.1, 1, 1000);
    const NeighborList list = list_of(p);
    auto once = zeros<Dim>(p.size()), onto = zeros<Dim>(p.size());
    for (auto& column : onto.c) column.assign(p.size(), 5.0);
    fluid_momentum<Dim, double>(p.view(), list, {}, once);
    fluid_momentum<Dim, double>(p.view(), list, {}, onto);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        for (int k = 0; k < Dim; ++k) wrong += onto[i][k] != 5.0 + once[i][k];
    CHECK(wrong == 0);
    CHECK(onto[p.size() - 1][0] == 5);
}

TEMPLATE_TEST_CASE_SIG("fluid passes have the same bits for any number of threads", "[fluid]",
                       ((int Dim, class Real), Dim, Real), (2, double), (2, float), (3, double), (3, float)) {
    const auto p = make_scene<Dim>(Scene::unequal);
    const NeighborList list = list_of(p);
    REQUIRE(list.size() > parallel_threshold);
    std::vector<VectorField<Dim>> momentum, filter;
    std::vector<ScalarField> rates;
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        auto a = zeros<Dim>(p.size()), correction = zeros<Dim>(p.size());
        ScalarField rate(p.size(), 0.0);
        fluid_momentum<Dim, Real>(p.view(), list, {0.5, 30}, a);
        velocity_filter<Dim, Real>(p.view(), list, 0.92, correction);
        continuity<Dim, Real>(p.view(), list, rate);
        momentum.push_back(a);
        filter.push_back(correction);
        rates.push_back(rate);
    }
    for (const std::size_t t : {1, 2}) {
        CHECK(same_bits(momentum[t], momentum[0]));
        CHECK(same_bits(filter[t], filter[0]));
        CHECK((rates[t] == rates[0]));
    }
}

TEMPLATE_TEST_CASE_SIG("single precision holds far from the origin", "[fluid]", ((int Dim), Dim), 2, 3) {
    auto p = make_scene<Dim>(Scene::unequal);
    for (auto& column : p.position.c)
        for (double& x : column) x += 4096;  // a float's grid there is 5e-4 m, a spacing is 0.1 m
    const auto expected = twin::fluid_momentum<Dim>(p, 0.5, 30);
    auto a = zeros<Dim>(p.size());
    fluid_momentum<Dim, float>(p.view(), list_of(p), {0.5, 30}, a);
    CHECK(worst_error(a, expected) < twin_tolerance<float>);
}
