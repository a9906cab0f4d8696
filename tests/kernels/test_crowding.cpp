// Particles too close to each other, against a plain twin.
#include "kernels/passes/crowding_passes.hpp"

#include "tests/catch.hpp"
#include "tests/kernels/compare.hpp"
#include "tests/kernels/twins.hpp"
#include "tests/kernels/variants.hpp"

namespace sluice::test_crowding {

namespace {

template <int Dim>
twin::Sums<1> crowding_twin(const Particles<Dim>& a, const Particles<Dim>& b, double reach_over_h) {
    return twin::sum_all<1>(a, b, [&](std::size_t, std::size_t, const twin::PairOf<Dim>& ij) {
        const double reach = reach_over_h * ij.h;
        return Vec<1>{{ij.r < reach ? 1 - ij.r * ij.r / (reach * reach) : 0}};
    });
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("crowding is that of all pairs", "[crowding]", ((int Dim), Dim), 2, 3) {
    for (const double reach_over_h : {0.3, 0.9}) {
        for (const Scene scene : {Scene::jittered, Scene::unequal, Scene::crowded}) {
            const auto a = make_scene<Dim>(scene, 1), b = make_scene<Dim>(scene, 2);
            for (const auto* others : {&a, &b}) {
                const auto expected = crowding_twin<Dim>(a, *others, reach_over_h);
                const NeighborList list = others == &a ? list_of(a) : list_of(a, b);
                in_all_variants([&](Precision) {
                    TupleField<1> found = zeros<1>(a.size());
                    CHECK(crowding_of<Dim>(a.view(), others->view(), list, reach_over_h, found.c[0]) == list.pairs());
                    // In double whatever is asked for.
                    CHECK(worst_error(found, expected) < twin_tolerance(Precision::full));
                });
            }
        }
    }
}

}  // namespace sluice::test_crowding
