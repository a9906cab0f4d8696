// Groups that share a list of candidates: nobody is left out, nobody is listed twice, and threads change nothing.
#include "tests/catch.hpp"
#include "tests/neighbor/search_cases.hpp"

using namespace sluice;

namespace {

/// The first broken rule of a list with groups, by name, or "".
template <int Dim>
std::string broken_rule(const SearchCase<Dim>& c, const NeighborList& list, int group_size) {
    const auto neighbors = c.plain();
    std::vector<int> listed(c.owned, 0);
    std::size_t members = 0;
    for (std::size_t g = 0; g < list.groups(); ++g) {
        const auto group = list.queries(g);
        if (group.empty() || group.size() > static_cast<std::size_t>(group_size))
            return "groups have 1 … group_size members";
        const auto candidates = ascending(list.candidates(g));
        if (candidates.empty()) return "a listed group has candidates";
        if (std::adjacent_find(candidates.begin(), candidates.end()) != candidates.end())
            return "candidates stand once";
        if (candidates.back() >= c.targets().size()) return "candidates are targets";
        for (const Index i : group) {
            if (i >= c.owned) return "members are owned";
            ++listed[i];
            ++members;
            if (!std::includes(candidates.begin(), candidates.end(), neighbors[i].begin(), neighbors[i].end()))
                return "candidates include every member's neighbours";
            // A pass may need a particle's own share, as the velocity filter does: it must not depend on who is near.
            if (c.same_set && group_size > 1 && !std::binary_search(candidates.begin(), candidates.end(), i))
                return "members are candidates themselves";
        }
    }
    if (members != list.size()) return "size() counts the members";
    const bool all_are_listed = c.same_set && group_size > 1;  // a particle is then a candidate of its own group
    for (std::size_t i = 0; i < c.owned; ++i) {
        if (listed[i] > 1) return "nobody stands in two groups";
        if (listed[i] == 0 && (all_are_listed || !neighbors[i].empty())) return "who has a neighbour stands in a group";
    }
    return "";
}

/// All that a list holds, byte for byte.
std::vector<Index> contents(const NeighborList& list) {
    std::vector<Index> all;
    for (std::size_t g = 0; g < list.groups(); ++g) {
        for (const auto part : {list.queries(g), list.candidates(g)}) {
            all.push_back(static_cast<Index>(part.size()));
            all.insert(all.end(), part.begin(), part.end());
        }
    }
    all.push_back(static_cast<Index>(list.pairs()));
    return all;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a group's candidates hold every member's neighbours", "[search]", ((int Dim), Dim), 2, 3) {
    for (const auto& c : search_cases<Dim>())
        for (const int group_size : {1, 2, 5, max_group_size}) {
            CAPTURE(c.name, group_size);
            CHECK(broken_rule(c, c.search(group_size), group_size) == "");
        }
}

TEMPLATE_TEST_CASE_SIG("lists are the same for any number of threads", "[search]", ((int Dim), Dim), 2, 3) {
    for (const auto& c : search_cases<Dim>())
        for (const int group_size : {1, max_group_size}) {
            std::vector<std::vector<Index>> lists;
            for (const int threads : {1, 2, 4}) {
                const ThreadScope scope(threads);
                lists.push_back(contents(c.search(group_size)));
            }
            CAPTURE(c.name, group_size);
            CHECK(lists[1] == lists[0]);
            CHECK(lists[2] == lists[0]);
        }
}

TEMPLATE_TEST_CASE_SIG("groups keep the grid's order, candidates too", "[search]", ((int Dim), Dim), 2, 3) {
    const auto c = search_cases<Dim>()[0];
    CellGrid<Dim> grid;
    grid.build(c.query, c.query.size(), c.cell, c.query_reach);
    std::vector<std::size_t> rank(c.query.size());
    for (std::size_t t = 0; t < rank.size(); ++t) rank[grid.order()[t]] = t;
    const NeighborList list = c.search(max_group_size);
    std::vector<std::size_t> ranks;
    for (std::size_t g = 0; g < list.groups(); ++g)
        for (const Index i : list.queries(g)) ranks.push_back(rank[i]);
    CHECK(std::is_sorted(ranks.begin(), ranks.end()));
}

TEMPLATE_TEST_CASE_SIG("a list stays complete until the skin is used up", "[search]", ((int Dim), Dim), 2, 3) {
    Random random(31);
    auto c = case_of<Dim>("moving", random_cloud<Dim>(800, 1, random), Dim == 2 ? 0.04 : 0.08);
    c.skin = 0.02;
    const NeighborList list = c.search(max_group_size);
    for (std::size_t i = 0; i < c.query.size(); ++i) {
        const auto step = random.vector<Dim>(-1, 1);
        c.query.set(i, c.query[i] + (0.499 * c.skin / norm(step)) * step);  // two of them: less than the skin
    }
    c.skin = 0;
    CHECK(broken_rule(c, list, max_group_size) == "");
}
