// Lists in use: pruned again and again, dealt out to threads, the same on every processor.
#include "tests/catch.hpp"
#include "tests/neighbor/list_rules.hpp"

using namespace sluice;

TEMPLATE_TEST_CASE_SIG("lists are the same for any number of threads and any instruction set", "[list]",
                       ((int Dim), Dim), 2, 3) {
    for (const auto& c : search_cases<Dim>()) {
        std::vector<std::vector<std::uint64_t>> built, pruned;
        for (const Isa isa : available_isas())
            for (const int threads : {1, 2, 4}) {
                const IsaScope scope(isa);
                built.push_back(contents(build(c, threads)));
                pruned.push_back(contents(search(c, threads)));
            }
        CAPTURE(c.name);
        for (std::size_t n = 1; n < built.size(); ++n) {
            CHECK((built[n] == built[0]));
            CHECK((pruned[n] == pruned[0]));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("shares cover all blocks, each once, with about equal work", "[list]", ((int Dim), Dim), 2, 3) {
    for (const auto& c : search_cases<Dim>()) {
        const NeighborList list = search(c);
        const ListView view = list.view();
        const auto work_of = [&](Index b) {
            std::uint64_t work = 0;
            for (Index p = view.block[b].parts.begin; p < view.block[b].parts.end; ++p)
                for (Index q = 0; q < view.block[b].queries.size(); ++q)
                    work += view.row[view.part[p].first_row + q].near;
            return work;
        };
        std::uint64_t heaviest = 0;
        for (Index b = 0; b < list.blocks(); ++b) heaviest = std::max(heaviest, work_of(b));
        for (const int n : {1, 2, 3, 7, 64, 1000}) {
            Index next = 0;
            std::uint64_t most = 0;
            for (int k = 0; k < n; ++k) {
                const Range share = list.share(k, n);
                REQUIRE(share.begin == next);
                REQUIRE(share.end >= share.begin);
                next = share.end;
                std::uint64_t work = 0;
                for (Index b = share.begin; b < share.end; ++b) work += work_of(b);
                most = std::max(most, work);
            }
            CAPTURE(c.name, n);
            CHECK(next == list.blocks());
            // A share's ends are rounded to whole blocks.
            CHECK(most <= list.cluster_pairs() / static_cast<std::uint64_t>(n) + heaviest + 1);
        }
    }
}

TEMPLATE_TEST_CASE_SIG(
    "pruning with a thinner skin keeps the pairs within it, and a thicker one brings the others back", "[list]",
    ((int Dim), Dim), 2, 3) {
    for (auto c : search_cases<Dim>()) {
        c.cut.skin = c.cut.skin > 0 ? c.cut.skin : 0.3 * c.cell;
        const auto thinner = [&c](double part) {
            return CutOff{part * c.cut.skin, c.cut.query_scale, c.cut.target_scale};
        };
        std::vector<std::vector<std::uint64_t>> on_each;
        for (const Isa isa : available_isas()) {
            const IsaScope scope(isa);
            NeighborList list = search(c);
            const std::uint64_t pairs = list.pairs(), cluster_pairs = list.cluster_pairs();
            CAPTURE(c.name, std::string(name_of(isa)));
            std::vector<std::uint64_t> all;
            for (const double part : {0.5, 0.0, 0.25, 1.0}) {
                prune(c, thinner(part), list, isa == Isa::baseline ? 1 : 2);
                CAPTURE(part);
                if (isa == Isa::baseline) CHECK(broken_rule_when_pruned_again(c, list, thinner(part)) == "");
                CHECK((part == 1 || list.cluster_pairs() <= cluster_pairs));
                CHECK(list.pairs() == pairs);
                const auto now = contents(list);
                all.insert(all.end(), now.begin(), now.end());
            }
            on_each.push_back(all);
        }
        CAPTURE(c.name);
        for (std::size_t n = 1; n < on_each.size(); ++n) CHECK((on_each[n] == on_each[0]));
    }
}

TEMPLATE_TEST_CASE_SIG("a list stays complete until the skin is used up", "[list]", ((int Dim), Dim), 2, 3) {
    Random random(31);
    for (const double away : {0.0, 1e4})  // [m]; a float's grid there is 1e-3 m, the skin 2e-2 m
        for (const bool heaps : {false, true}) {
            const auto x = heaps ? clustered_cloud<Dim>(900, 1, random) : random_cloud<Dim>(900, 1, random);
            auto c = case_of<Dim>("moving", x, Dim == 2 ? 0.04 : 0.08);
            for (double& y : c.query.c[Dim - 1]) y += away;
            c.query_reach = random_reach(900, 0.5 * c.query_reach[0], random);
            c.owned = 600;
            c.cut.skin = 0.02;
            NeighborList list = search(c);
            const auto start = c.query;
            for (const double used : {0.5, 0.999}) {  // by two particles together, as a part of the skin
                for (std::size_t i = 0; i < c.query.size(); ++i) {
                    const auto step = random.vector<Dim>(-1, 1);
                    c.query.set(i, start[i] + (0.5 * used * c.cut.skin / norm(step)) * step);
                }
                const CutOff left{(0.999 - used) * c.cut.skin};
                CAPTURE(away, heaps, used);
                CHECK(ListReader<Dim>(c, list, {}).broken_rule() == "");  // as pruned before the move
                prune(c, left, list);
                CHECK(broken_rule_when_pruned_again(c, list, left) == "");
                c.query = start;
                prune(c, c.cut, list);
            }
        }
}

TEMPLATE_TEST_CASE_SIG("a search keeps nothing of the one before", "[list]", ((int Dim), Dim), 2, 3) {
    const ThreadScope scope(1);
    NeighborSearch<Dim> searcher;
    NeighborList list;
    const auto cases = search_cases<Dim>();
    for (std::size_t n = 0; n < cases.size(); ++n) {
        const auto& c = cases[n % 2 ? n : cases.size() - 1 - n];  // large and small by turns
        const SearchGrids<Dim> grids(c);
        searcher.build(grids.owned, grids.targets, c.cut, list);
        searcher.prune(c.queries(), c.targets(), c.cut, list);
        CAPTURE(c.name);
        CHECK((contents(list) == contents(search(c))));
    }
}
