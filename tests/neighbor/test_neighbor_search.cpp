// The search against its plain twin: lists hold every pair, and once pruned no cluster without one.
#include <cmath>
#include <limits>

#include "tests/catch.hpp"
#include "tests/neighbor/list_rules.hpp"

namespace sluice::test_neighbor_search {

namespace {

/// Directed pairs within the cut-off without the skin, counted by looking at every pair.
template <int Dim>
std::uint64_t count_pairs(const SearchCase<Dim>& c) {
    std::uint64_t pairs = 0;
    for (const auto& near : c.plain({0, c.cut.query_scale, c.cut.target_scale})) pairs += near.size();
    return pairs;
}

/// Most candidates of a block.
std::size_t most_candidates(const NeighborList& list) {
    const ListView view = list.view();
    std::size_t most = 0;
    for (std::size_t b = 0; b < list.blocks(); ++b) {
        std::size_t candidates = 0;
        for (Index p = view.block[b].parts.begin; p < view.block[b].parts.end; ++p)
            candidates += view.part[p].candidates.size();
        most = std::max(most, candidates);
    }
    return most;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a list holds every pair when it is built", "[search]", ((int Dim), Dim), 2, 3) {
    for (const auto& c : search_cases<Dim>()) {
        const NeighborList list = build(c);
        CAPTURE(c.name);
        CHECK(ListReader<Dim>(c, list, c.cut).broken_rule() == "");
    }
}

TEMPLATE_TEST_CASE_SIG("a pruned list holds every pair and no cluster without one", "[search]", ((int Dim), Dim), 2,
                       3) {
    for (const auto& c : search_cases<Dim>()) {
        CAPTURE(c.name);
        CHECK(broken_rule(c, search(c), c.cut) == "");
    }
}

TEMPLATE_TEST_CASE_SIG("pairs() counts the directed pairs inside the cut-off, not those of the skin", "[search]",
                       ((int Dim), Dim), 2, 3) {
    for (const auto& c : search_cases<Dim>()) {
        const std::uint64_t expected = count_pairs(c);
        for (const Isa isa : available_isas()) {
            const IsaScope scope(isa);
            CAPTURE(c.name, std::string(name_of(isa)));
            CHECK(search(c).pairs() == expected);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("the cases are what they claim to be", "[search]", ((int Dim), Dim), 2, 3) {
    std::size_t several_parts = 0, ties = 0;
    for (const auto& c : search_cases<Dim>()) {
        if (c.owned == 0) continue;
        several_parts += most_candidates(search(c)) > part_size;
        // One more unit in the last place, and pairs come in.
        const CutOff wider{c.cut.skin + 1e-9 * c.cell, c.cut.query_scale, c.cut.target_scale};
        ties += c.plain(c.cut) != c.plain(wider);
    }
    CHECK(several_parts > 0);
    CHECK(ties > 0);
}

TEMPLATE_TEST_CASE_SIG("pairs that only rounding keeps apart from the cut-off are decided alike by build and prune",
                       "[search]", ((int Dim), Dim), 2, 3) {
    // At the distances fl(fl(h + skin) + h) and fl(fl(h + h) + skin), and one rounding to either side of each.
    Random random(41);
    std::size_t inside = 0, outside = 0, broken = 0;
    for (int n = 0; n < 300; ++n) {
        const double h = random.in(0.05, 0.2), skin = random.in(0.01, 0.1);
        for (const double sum : {h + skin + h, h + h + skin})
            for (const double distance : {std::nextafter(sum, 0.0), sum, std::nextafter(sum, 1.0)}) {
                auto c = case_of<Dim>("tie", lattice_points<Dim>(1, 1), h);
                Vec<Dim> x;
                x[1] = distance;
                c.query.push_back(x);
                c.query_reach.push_back(h);
                c.owned = 2;
                c.cell = 0.5 * h;
                c.cut.skin = skin;
                broken += broken_rule(c, search(c), c.cut) != "";
                (c.plain(c.cut)[0].empty() ? outside : inside) += 1;
            }
    }
    CHECK(broken == 0);
    CHECK(inside > 300);
    CHECK(outside > 300);
}

TEMPLATE_TEST_CASE_SIG("all particles with one reach have rows of equal reach", "[search]", ((int Dim), Dim), 2, 3) {
    const auto c = search_cases<Dim>()[0];
    const NeighborList list = search(c);
    std::size_t unequal = 0;
    for (std::size_t b = 0; b < list.blocks(); ++b)
        for (Index q = list.view().block[b].queries.begin; q < list.view().block[b].queries.end; ++q)
            unequal += !list.view().equal_reach[q];
    CHECK(unequal == 0);
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
    const NeighborList list = search(c);
    CHECK(broken_rule(c, list, c.cut) == "");
    CHECK(list.pairs() == count_pairs(c));
}

TEMPLATE_TEST_CASE_SIG("queries keep the grid's order", "[search]", ((int Dim), Dim), 2, 3) {
    const auto c = search_cases<Dim>()[0];
    const SearchGrids<Dim> grids(c);
    const NeighborList list = search(c);
    std::vector<Index> queries;
    for (std::size_t b = 0; b < list.blocks(); ++b)
        for (Index q = list.view().block[b].queries.begin; q < list.view().block[b].queries.end; ++q)
            list.for_queries(q, [&](Index i) { queries.push_back(i); });
    CHECK(std::equal(queries.begin(), queries.end(), grids.owned.order().begin(), grids.owned.order().end()));
}

TEMPLATE_TEST_CASE_SIG("sorted particles are listed as runs of memory", "[search]", ((int Dim), Dim), 2, 3) {
    Random random(29);
    auto c = case_of<Dim>("sorted", clustered_cloud<Dim>(1500, 1, random), Dim == 2 ? 0.03 : 0.07);
    c.owned = 1000;
    const auto in_sequence = [](const NeighborList& list) {
        const ListView view = list.view();
        std::size_t runs = 0, all = 0;
        for (std::size_t b = 0; b < list.blocks(); ++b) {
            const ListView::Block& block = view.block[b];
            for (Index q = block.queries.begin; q < block.queries.end; ++q, ++all) runs += view.query[q].in_sequence;
            for (Index n = view.part[block.parts.begin].candidates.begin;
                 n < view.part[block.parts.end - 1].candidates.end; ++n, ++all)
                runs += view.candidate[n].in_sequence;
        }
        return static_cast<double>(runs) / static_cast<double>(all);
    };
    CHECK(in_sequence(search(c)) < 0.5);  // clusters of one particle are runs
    SearchGrids<Dim> grids(c);
    std::vector<Index> order(grids.owned.order().begin(), grids.owned.order().end());
    order.insert(order.end(), grids.others.order().begin(), grids.others.order().end());
    c.query = reordered(c.query, order);
    grids.owned.particles_were_sorted(0);
    grids.others.particles_were_sorted(c.owned);
    NeighborList list;
    NeighborSearch<Dim>().build(grids.owned, grids.targets, c.cut, list);
    prune(c, c.cut, list);
    CHECK(in_sequence(list) == 1);
    CHECK(broken_rule(c, list, c.cut) == "");
    CHECK((contents(list) == contents(search(c))));  // told or built anew, a grid is the same
}

TEMPLATE_TEST_CASE_SIG("a position that is not a number has no pairs and costs nobody any", "[search]",
                       ((int Dim), Dim), 2, 3) {
    Random random(37);
    auto c = case_of<Dim>("broken", random_cloud<Dim>(900, 1, random), Dim == 2 ? 0.05 : 0.1);
    for (const std::size_t i : {5, 300, 899}) c.query.c[i % Dim][i] = std::numeric_limits<double>::quiet_NaN();
    const auto neighbors = c.plain(c.cut);
    for (const Isa isa : available_isas()) {
        const IsaScope scope(isa);
        const NeighborList list = search(c);
        const ListView view = list.view();
        std::size_t missing = 0;
        for (std::size_t b = 0; b < list.blocks(); ++b)
            for (Index q = view.block[b].queries.begin; q < view.block[b].queries.end; ++q) {
                std::vector<char> covered(c.query.size(), 0);
                for (Index p = view.block[b].parts.begin; p < view.block[b].parts.end; ++p) {
                    const auto& row = view.row[view.part[p].first_row + (q - view.block[b].queries.begin)];
                    for (std::uint32_t e = 0; e < row.near; ++e)
                        list.for_candidates(view.part[p].candidates.begin + view.entry[row.begin + e],
                                            [&](Index j) { covered[j] = 1; });
                }
                list.for_queries(q, [&](Index i) {
                    for (const Index j : neighbors[i]) missing += !covered[j];
                });
            }
        CAPTURE(std::string(name_of(isa)));
        CHECK(missing == 0);
    }
}

TEST_CASE("a list is cleared by a search that finds nothing", "[search]") {
    const auto c = search_cases<2>()[0];
    const SearchGrids<2> grids(c);
    const VectorField<2> nobody;
    ClusterGrid<2> none;
    none.build(nobody, 0, 0, c.cell);
    const ClusterGrid<2>* const target = &none;
    NeighborSearch<2> searcher;
    NeighborList list;
    searcher.build(grids.owned, grids.targets, c.cut, list);
    searcher.prune(c.queries(), c.targets(), c.cut, list);
    REQUIRE(list.blocks() > 0);
    REQUIRE(list.pairs() > 0);
    const auto check_empty = [&] {
        searcher.prune(c.queries(), {nobody, {}}, c.cut, list);
        CHECK(list.blocks() == 0);
        CHECK(list.size() == 0);
        CHECK(list.pairs() == 0);
        CHECK(list.cluster_pairs() == 0);
        CHECK(list.share(0, 1).size() == 0);
    };
    searcher.build(grids.owned, {&target, 1}, c.cut, list);
    check_empty();
    searcher.build(grids.owned, {}, c.cut, list);
    check_empty();
}

}  // namespace sluice::test_neighbor_search
