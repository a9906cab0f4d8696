// Two sets of particles, what is asked of them, and the lists found: shared by the tests of the search.
#pragma once

#include <algorithm>
#include <string>
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
    std::size_t owned = 0;
    double cell = 0.1;
    double skin = 0;
    double query_scale = 1, target_scale = 1;

    const VectorField<Dim>& targets() const { return same_set ? query : target; }
    PairReach reach() const {
        return {query_reach, same_set ? query_reach : target_reach, skin, query_scale, target_scale};
    }
    NeighborList search(int group_size) const {
        CellGrid<Dim> query_grid, target_grid;
        query_grid.build(query, query.size(), cell, query_reach);
        if (!same_set) target_grid.build(target, target.size(), cell, target_reach);
        NeighborList list;
        NeighborSearch<Dim>().build({query, query_grid}, owned, {targets(), same_set ? query_grid : target_grid},
                                    reach(), group_size, list);
        return list;
    }
    std::vector<std::vector<Index>> plain() const { return all_pairs(query, owned, targets(), reach()); }
};

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
        all.back().skin = 0.6 * d;  // 2h + skin = 3 d: ties at the cut-off
        all.back().cell = 3 * d;
    }
    all.push_back(case_of<Dim>("heaps", clustered_cloud<Dim>(n, 1, random), h));
    all.push_back(case_of<Dim>("one point", VectorField<Dim>(), h));
    for (int i = 0; i < 100; ++i) all.back().query.push_back(Vec<Dim>{});
    all.back().query_reach.assign(100, h);
    all.back().owned = 100;

    SearchCase<Dim> unequal = case_of<Dim>("unequal reaches", clustered_cloud<Dim>(n, 1, random), h);
    unequal.query_reach = random_reach(n, 0.4 * h, random);
    unequal.cell = 2 * 0.4 * h;
    all.push_back(unequal);
    unequal.name = "unequal reaches with skin, some owned";
    unequal.skin = 0.1 * h;
    unequal.owned = 700;
    all.push_back(unequal);
    unequal.name = "scaled reaches";
    unequal.query_scale = 0.5;
    unequal.target_scale = 1.75;
    all.push_back(unequal);

    SearchCase<Dim> two = case_of<Dim>("two sets", random_cloud<Dim>(n, 1, random), h);
    two.same_set = false;
    two.target = clustered_cloud<Dim>(n / 2, 1.5, random);
    two.target_reach = random_reach(n / 2, 0.5 * h, random);
    two.owned = 900;
    two.skin = 0.2 * h;
    all.push_back(two);
    two.name = "elements without a reach among particles";  // as of interface and fluid
    two.query_reach.clear();
    two.target_scale = 2;
    all.push_back(two);
    two.name = "particles among elements without a reach";
    std::swap(two.query, two.target);
    std::swap(two.query_reach, two.target_reach);
    std::swap(two.query_scale, two.target_scale);
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

inline std::vector<Index> ascending(std::span<const Index> list) {
    std::vector<Index> v(list.begin(), list.end());
    std::sort(v.begin(), v.end());
    return v;
}

}  // namespace sluice
