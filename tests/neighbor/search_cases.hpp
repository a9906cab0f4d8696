// Two sets of particles, what is asked of them, and the lists found: shared by the tests of the search.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "neighbor/all_pairs.hpp"
#include "neighbor/neighbor_list.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice {

template <int Dim>
struct SearchCase {
    std::string name;
    VectorField<Dim> query, target;
    bool same_set = true;  ///< search the query set in itself
    ScalarField query_reach, target_reach;
    std::size_t owned = 0;  ///< queries; in one set the others are targets in a grid of their own
    double cell = 0.1;
    CutOff cut;

    using Set = typename NeighborSearch<Dim>::Set;
    Set queries() const { return {query, query_reach}; }
    Set targets() const { return same_set ? queries() : Set{target, target_reach}; }
    std::vector<std::vector<Index>> plain(const CutOff& within) const {
        return all_pairs<Dim>(queries(), owned, targets(), within);
    }
};

/// The grids of a case, as an engine keeps them.
template <int Dim>
struct SearchGrids {
    ClusterGrid<Dim> owned, others;
    std::vector<const ClusterGrid<Dim>*> targets;

    explicit SearchGrids(const SearchCase<Dim>& c) {
        owned.build(c.query, 0, c.owned, c.cell, c.query_reach);
        const auto set = c.targets();
        others.build(set.position, c.same_set ? c.owned : 0, set.position.size(), c.cell, set.reach);
        if (c.same_set) targets.push_back(&owned);
        targets.push_back(&others);
    }
    SearchGrids(const SearchGrids&) = delete;  // targets point into it
    SearchGrids& operator=(const SearchGrids&) = delete;
};

/// A case's list, not pruned yet. One thread unless threads are what is tested: a team waits for processors that other
/// programs use.
template <int Dim>
NeighborList build(const SearchCase<Dim>& c, int threads = 1) {
    const ThreadScope scope(threads);
    const SearchGrids<Dim> grids(c);
    NeighborList list;
    NeighborSearch<Dim>().build(grids.owned, grids.targets, c.cut, list);
    return list;
}

template <int Dim>
void prune(const SearchCase<Dim>& c, const CutOff& cut, NeighborList& list, int threads = 1) {
    const ThreadScope scope(threads);
    NeighborSearch<Dim>().prune(c.queries(), c.targets(), cut, list);
}

/// A case's list, pruned to the cut-off that it was built for.
template <int Dim>
NeighborList search(const SearchCase<Dim>& c, int threads = 1) {
    NeighborList list = build(c, threads);
    prune(c, c.cut, list, threads);
    return list;
}

template <int Dim>
SearchCase<Dim> case_of(std::string name, VectorField<Dim> x, double h) {
    SearchCase<Dim> c;
    c.name = std::move(name);
    c.query = std::move(x);
    c.query_reach.assign(c.query.size(), h);
    c.owned = c.query.size();
    c.cell = 2 * h;
    return c;
}

/// n particles in a row's reach of each other, and a cloud around them: blocks whose candidates fill several parts.
template <int Dim>
SearchCase<Dim> dense_heap(std::size_t n, Random& random) {
    auto x = random_cloud<Dim>(n, 0.05, random);
    for (int i = 0; i < 200; ++i) x.push_back(random.vector<Dim>(-0.3, 0.3));
    return case_of<Dim>("dense heap", x, 0.04);
}

/// Clouds, lattices and heaps; equal and unequal reaches; one set and two; with and without a skin.
template <int Dim>
std::vector<SearchCase<Dim>> search_cases() {
    Random random(17);
    const std::size_t n = 1200;
    const double h = Dim == 2 ? 0.03 : 0.07;
    std::vector<SearchCase<Dim>> all;
    all.push_back(case_of<Dim>("cloud", random_cloud<Dim>(n, 1, random), h));
    for (const double d : {0.1, 1.0 / 3, 0.005 / 6}) {
        all.push_back(case_of<Dim>("lattice", lattice_points<Dim>(Dim == 2 ? 25 : 9, d), 1.5 * d));
        all.push_back(case_of<Dim>("lattice with skin", lattice_points<Dim>(Dim == 2 ? 25 : 9, d), 1.2 * d));
        all.back().cut.skin = 0.6 * d;  // 2h + skin = 3 d: ties at the cut-off
        all.back().cell = 3 * d;
    }
    all.push_back(case_of<Dim>("heaps", clustered_cloud<Dim>(n, 1, random), h));
    VectorField<Dim> point;
    for (int i = 0; i < 101; ++i) point.push_back(Vec<Dim>{});
    all.push_back(case_of<Dim>("one point", point, h));
    all.push_back(dense_heap<Dim>(1300, random));

    SearchCase<Dim> unequal = case_of<Dim>("unequal reaches", clustered_cloud<Dim>(n, 1, random), h);
    unequal.query_reach = random_reach(n, 0.4 * h, random);
    unequal.cell = 2 * 0.4 * h;
    all.push_back(unequal);
    unequal.name = "unequal reaches with skin, some owned";
    unequal.cut.skin = 0.1 * h;
    unequal.owned = 700;
    all.push_back(unequal);
    unequal.name = "scaled reaches";
    unequal.cut.query_scale = 0.5;
    unequal.cut.target_scale = 1.75;
    all.push_back(unequal);

    SearchCase<Dim> two = case_of<Dim>("two sets", random_cloud<Dim>(n, 1, random), h);
    two.same_set = false;
    two.target = clustered_cloud<Dim>(n / 2, 1.5, random);
    two.target_reach = random_reach(n / 2, 0.5 * h, random);
    two.owned = 900;
    two.cut.skin = 0.2 * h;
    all.push_back(two);
    two.name = "elements without a reach among particles";  // as of interface and fluid
    two.query_reach.assign(n, 0.0);
    two.cut.target_scale = 2;
    all.push_back(two);
    two.name = "particles among elements without a reach";
    std::swap(two.query, two.target);
    std::swap(two.query_reach, two.target_reach);
    std::swap(two.cut.query_scale, two.cut.target_scale);
    two.owned = 450;
    all.push_back(two);
    two.name = "sets far apart";
    for (double& x : two.target.c[0]) x += 1e5;
    all.push_back(two);
    two.name = "no targets";
    two.target = {};
    all.push_back(two);
    all.push_back(case_of<Dim>("nothing", VectorField<Dim>(), h));
    all.push_back(case_of<Dim>("two strays", lattice_points<Dim>(2, 100), h));
    return all;
}

}  // namespace sluice
