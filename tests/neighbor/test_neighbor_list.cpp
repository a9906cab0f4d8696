// Lists in use: pruned again and again, dealt out to threads, the same on every processor.
#include <algorithm>
#include <map>

#include "tests/catch.hpp"
#include "tests/neighbor/list_rules.hpp"

namespace sluice::test_neighbor_list {

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

namespace {

constexpr std::uint64_t end_of_part = ~std::uint64_t{0};

/// Candidates of a query cluster that its rows hold, in order, and where a part ends.
std::vector<std::uint64_t> row_of(const NeighborList& list, const ListView::Block& block, Index q) {
    const ListView view = list.view();
    std::vector<std::uint64_t> row{view.equal_reach[q]};
    for (Index p = block.parts.begin; p < block.parts.end; ++p) {
        const ListView::Row& r = view.row[view.part[p].first_row + (q - block.queries.begin)];
        for (std::uint32_t e = 0; e < r.near; ++e)
            list.for_candidates(view.part[p].candidates.begin + view.entry[r.begin + e],
                                [&](Index j) { row.push_back(j); });
        row.push_back(end_of_part);
    }
    return row;
}

/// Each query cluster's row, by the cluster's particles.
std::map<std::vector<Index>, std::vector<std::uint64_t>> rows_of(const NeighborList& list) {
    std::map<std::vector<Index>, std::vector<std::uint64_t>> rows;
    for (std::size_t b = 0; b < list.blocks(); ++b) {
        const ListView::Block& block = list.view().block[b];
        for (Index q = block.queries.begin; q < block.queries.end; ++q) {
            std::vector<Index> members;
            list.for_queries(q, [&](Index i) { members.push_back(i); });
            rows[members] = row_of(list, block, q);
        }
    }
    return rows;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("queries that are kept keep their rows, and the others are gone", "[list]", ((int Dim), Dim), 2,
                       3) {
    Random random(5);
    for (const auto& c : search_cases<Dim>()) {
        const NeighborList whole = search(c);
        // A half space and some strays, as a clamp has it; all; none.
        std::vector<std::uint8_t> some(c.query.size()), all(c.query.size(), 1), none(c.query.size(), 0);
        for (std::size_t i = 0; i < some.size(); ++i) some[i] = c.query[i][0] > 0.4 || random.vector<1>(0, 1)[0] < 0.02;
        for (const auto& wanted : {some, all, none}) {
            NeighborList kept = whole;
            kept.keep_queries(wanted);
            prune(c, c.cut, kept);
            const auto before = rows_of(whole), after = rows_of(kept);
            std::size_t size = 0;
            bool same = true, right = true;
            for (const auto& [members, row] : before) {
                const bool is_wanted =
                    std::any_of(members.begin(), members.end(), [&](Index i) { return wanted[i] != 0; });
                const auto found = after.find(members);
                right = right && (found != after.end()) == is_wanted;
                same = same && (found == after.end() || found->second == row);
                if (is_wanted) size += members.size();
            }
            CAPTURE(c.name);
            CHECK(same);
            CHECK(right);
            CHECK(after.size() <= before.size());
            CHECK(kept.size() == size);
            CHECK(kept.pairs() <= whole.pairs());
        }
    }
}

TEMPLATE_TEST_CASE_SIG("the candidates that are marked are those of the rows asked for", "[list]", ((int Dim), Dim), 2,
                       3) {
    Random random(6);
    for (const auto& c : search_cases<Dim>()) {
        const NeighborList list = search(c);
        std::vector<std::uint8_t> wanted(c.query.size()), marked(c.targets().position.size()), expected(marked.size());
        for (std::uint8_t& w : wanted) w = random.vector<1>(0, 1)[0] < 0.1;
        list.mark_candidates(wanted, marked);
        for (const auto& [members, row] : rows_of(list)) {
            if (std::none_of(members.begin(), members.end(), [&](Index i) { return wanted[i] != 0; })) continue;
            for (std::size_t n = 1; n < row.size(); ++n)
                if (row[n] != end_of_part) expected[row[n]] = 1;
        }
        CAPTURE(c.name);
        CHECK((marked == expected));
    }
}

}  // namespace sluice::test_neighbor_list
