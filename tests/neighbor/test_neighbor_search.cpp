// The search against its plain twin, particle by particle: lists with groups of one.
#include "tests/catch.hpp"
#include "tests/neighbor/search_cases.hpp"

using namespace sluice;

namespace {

/// Directed pairs within the cut-off without the skin, counted by looking at every pair.
template <int Dim>
std::uint64_t count_pairs(SearchCase<Dim> c) {
    c.skin = 0;
    std::uint64_t pairs = 0;
    for (const auto& near : c.plain()) pairs += near.size();
    return pairs;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a group of one has exactly the particle's own neighbours", "[search]", ((int Dim), Dim), 2, 3) {
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        for (const auto& c : search_cases<Dim>()) {
            const NeighborList list = c.search(1);
            auto expected = c.plain();
            std::size_t wrong = 0, several = 0;
            for (std::size_t g = 0; g < list.groups(); ++g) {
                several += list.queries(g).size() != 1;
                const Index i = list.queries(g)[0];
                wrong += i >= c.owned || list.candidates(g).empty() || ascending(list.candidates(g)) != expected[i];
                if (i < c.owned) expected[i].clear();
            }
            std::size_t missing = 0;
            for (const auto& near : expected) missing += !near.empty();
            CAPTURE(threads, c.name);
            CHECK(several == 0);
            CHECK(wrong == 0);
            CHECK(missing == 0);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("pairs() counts the directed pairs inside the cut-off, not those of the skin", "[search]",
                       ((int Dim), Dim), 2, 3) {
    for (const auto& c : search_cases<Dim>()) {
        const std::uint64_t expected = count_pairs(c);
        CAPTURE(c.name);
        for (const int group_size : {1, 3, max_group_size}) CHECK(c.search(group_size).pairs() == expected);
    }
}

TEMPLATE_TEST_CASE_SIG("neighbours are found far from the grid's origin", "[search]", ((int Dim), Dim), 2, 3) {
    // One particle far away stretches the grid: cells have large numbers, and their edges are known to 1e-10 m only.
    Random random(23);
    auto c = case_of<Dim>("far", random_cloud<Dim>(1500, 1, random), Dim == 2 ? 0.05 : 0.5);
    Vec<Dim> away;
    away[0] = -1e6;
    c.query.push_back(away);
    c.query_reach.push_back(c.query_reach[0]);
    c.owned = c.query.size();
    const NeighborList list = c.search(1);
    const auto expected = c.plain();
    std::size_t wrong = 0;
    for (std::size_t g = 0; g < list.groups(); ++g)
        wrong += ascending(list.candidates(g)) != expected[list.queries(g)[0]];
    CHECK(wrong == 0);
    CHECK(list.pairs() == count_pairs(c));
}

TEST_CASE("a list is cleared by a search that finds nothing", "[search]") {
    auto c = search_cases<2>()[0];
    CellGrid<2> grid, none;
    grid.build(c.query, c.query.size(), c.cell, c.query_reach);
    const VectorField<2> nobody;
    none.build(nobody, 0, c.cell);
    NeighborSearch<2> search;
    NeighborList list;
    search.build({c.query, grid}, c.owned, {c.query, grid}, c.reach(), 8, list);
    REQUIRE(list.groups() > 0);
    search.build({c.query, grid}, c.owned, {nobody, none}, c.reach(), 8, list);
    CHECK(list.groups() == 0);
    CHECK(list.size() == 0);
    CHECK(list.pairs() == 0);
}
