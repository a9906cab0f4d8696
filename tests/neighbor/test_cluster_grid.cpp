// Cluster grids: cells cut into clusters and blocks, which hold every particle once and are measured exactly.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "neighbor/cluster_grid.hpp"
#include "tests/catch.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_cluster_grid {

namespace {

template <int Dim>
std::vector<Index> order_of(const ClusterGrid<Dim>& grid) {
    std::vector<Index> order;
    for (std::size_t t = 0; t < grid.size(); ++t) order.push_back(grid.particle(t));
    return order;
}


template <int Dim>
struct Points {
    VectorField<Dim> x;
    ScalarField h;
    std::size_t size() const { return x.size(); }
};

template <int Dim>
Points<Dim> points_of(VectorField<Dim> x, Random& random) {
    const std::size_t n = x.size();
    return {std::move(x), random_reach(n, 0.01, random)};
}

/// A cloud, heaps, a lattice, one point many times over; cells of 0.1 hold a few particles or several blocks.
template <int Dim>
std::vector<Points<Dim>> point_sets() {
    Random random(3);
    std::vector<Points<Dim>> sets;
    for (const std::size_t n : {1, 4, 5, 64, 65, 3000})
        sets.push_back(points_of(random_cloud<Dim>(n, 0.3, random), random));
    sets.push_back(points_of(clustered_cloud<Dim>(4000, 1, random), random));
    sets.push_back(points_of(lattice_points<Dim>(Dim == 2 ? 40 : 13, 0.1 / 3), random));
    VectorField<Dim> heap;
    for (int i = 0; i < 700; ++i) heap.push_back(Random(1).vector<Dim>(0, 1));
    sets.push_back(points_of(heap, random));
    return sets;
}

template <int Dim>
bool same_extent(const Extent<Dim>& a, const Extent<Dim>& b) {
    return a.box.lo == b.box.lo && a.box.hi == b.box.hi && a.min_reach == b.min_reach && a.max_reach == b.max_reach;
}

/// The extent of the particles order[begin, end); coordinates that are not numbers do not count.
template <int Dim>
Extent<Dim> extent_of(const ClusterGrid<Dim>& grid, const Points<Dim>& p, Range range) {
    Extent<Dim> e;
    for (Index t = range.begin; t < range.end; ++t) {
        const Index i = grid.particle(t);
        for (int k = 0; k < Dim; ++k) {
            e.box.lo[k] = std::fmin(e.box.lo[k], p.x[i][k]);
            e.box.hi[k] = std::fmax(e.box.hi[k], p.x[i][k]);
        }
        e.min_reach = std::min(e.min_reach, p.h[i]);
        e.max_reach = std::max(e.max_reach, p.h[i]);
    }
    return e;
}

/// The number of each position's cell, in Morton order.
template <int Dim>
std::vector<std::size_t> cell_numbers(const Points<Dim>& p, std::size_t first, std::size_t last, double cell) {
    CellGrid<Dim> cells;
    cells.build(p.x, first, last, cell);
    std::vector<std::size_t> number(last);
    for (std::size_t c = 0; c < cells.cells().size(); ++c)
        for (Index t = cells.cells()[c].begin; t < cells.cells()[c].end; ++t) number[cells.order()[t]] = c;
    return number;
}

/// What holds for the clusters of every grid; the first broken rule by name, or "".
template <int Dim>
std::string broken_cluster_rule(const ClusterGrid<Dim>& grid, const Points<Dim>& p, std::size_t clusters,
                                const std::vector<std::size_t>& cell) {
    Index next = 0;
    std::size_t last_cell = 0;
    for (std::size_t c = 0; c < clusters; ++c) {
        const Range range = grid.particles(c);
        if (range.begin != next || range.size() < 1 || range.size() > cluster_size)
            return "clusters follow each other and hold 1 … 4 particles";
        next = range.end;
        const std::size_t own = cell[grid.particle(range.begin)];
        for (Index t = range.begin; t < range.end; ++t)
            if (cell[grid.particle(t)] != own) return "a cluster lies in one cell";
        if (own < last_cell) return "cells come in Morton order";
        last_cell = own;
        const bool last_of_cell = range.end == grid.size() || cell[grid.particle(range.end)] != own;
        if (range.size() < cluster_size && !last_of_cell) return "all clusters of a cell but its last are full";
        if (!same_extent(grid.cluster_extent(c), extent_of(grid, p, range))) return "a cluster's extent is exact";
    }
    return next == grid.size() ? "" : "every particle is in a cluster";
}

/// What holds for every grid of the positions first … last − 1; the first broken rule by name, or "".
template <int Dim>
std::string broken_rule(const ClusterGrid<Dim>& grid, const Points<Dim>& p, std::size_t first, std::size_t last,
                        double cell_size) {
    if (grid.size() != last - first || order_of(grid).size() != grid.size()) return "size() counts the positions";
    std::vector<int> seen(last, 0);
    for (const Index i : order_of(grid))
        if (i < first || i >= last || seen[i]++) return "order is a permutation";
    const auto cell = cell_numbers(p, first, last, cell_size);
    Index next = 0;
    for (std::size_t b = 0; b < grid.blocks(); ++b) {
        const Range clusters = grid.clusters(b);
        if (clusters.begin != next || clusters.size() < 1 || clusters.size() > block_size)
            return "blocks follow each other and hold 1 … 16 clusters";
        next = clusters.end;
        const Range all{grid.particles(clusters.begin).begin, grid.particles(clusters.end - 1).end};
        const std::size_t own = cell[grid.particle(all.begin)];
        if (cell[grid.particle(all.end - 1)] != own) return "a block lies in one cell";
        const bool last_of_cell = all.end == grid.size() || cell[grid.particle(all.end)] != own;
        if (clusters.size() < block_size && !last_of_cell) return "all blocks of a cell but its last are full";
        if (!same_extent(grid.block_extent(b), extent_of(grid, p, all))) return "a block's extent is exact";
    }
    return broken_cluster_rule(grid, p, next, cell);
}

/// Order, clusters, blocks and extents, number by number.
template <int Dim>
std::vector<double> contents(const ClusterGrid<Dim>& grid) {
    const std::vector<Index> order = order_of(grid);
    std::vector<double> all(order.begin(), order.end());
    const auto add = [&](const Extent<Dim>& e) {
        all.insert(all.end(), e.box.lo.c.begin(), e.box.lo.c.end());
        all.insert(all.end(), e.box.hi.c.begin(), e.box.hi.c.end());
        all.push_back(e.min_reach);
        all.push_back(e.max_reach);
    };
    for (std::size_t b = 0; b < grid.blocks(); ++b) {
        add(grid.block_extent(b));
        const Range clusters = grid.clusters(b);
        for (Index c = clusters.begin; c < clusters.end; ++c) {
            all.push_back(grid.particles(c).end);
            add(grid.cluster_extent(c));
        }
    }
    return all;
}

/// Clusters as sets of names, in the grid's order.
template <int Dim>
std::vector<std::set<std::size_t>> members(const ClusterGrid<Dim>& grid, const std::vector<std::size_t>& name) {
    std::vector<std::set<std::size_t>> all;
    for (std::size_t b = 0; b < grid.blocks(); ++b)
        for (Index c = grid.clusters(b).begin; c < grid.clusters(b).end; ++c) {
            all.emplace_back();
            for (Index t = grid.particles(c).begin; t < grid.particles(c).end; ++t)
                all.back().insert(name[grid.particle(t)]);
        }
    return all;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("every particle stands in exactly one cluster", "[cluster_grid]", ((int Dim), Dim), 2, 3) {
    ClusterGrid<Dim> grid;  // one for all: buffers are reused
    for (const auto& p : point_sets<Dim>()) {
        CAPTURE(p.size());
        grid.build(p.x, 0, p.size(), 0.1, p.h);
        CHECK(broken_rule(grid, p, 0, p.size(), 0.1) == "");
        const std::size_t first = p.size() / 3;
        grid.build(p.x, first, p.size(), 0.05, p.h);
        CHECK(broken_rule(grid, p, first, p.size(), 0.05) == "");
    }
}

TEMPLATE_TEST_CASE_SIG("a grid without reaches, and one of nothing", "[cluster_grid]", ((int Dim), Dim), 2, 3) {
    Random random(4);
    Points<Dim> p = points_of(random_cloud<Dim>(500, 1, random), random);
    p.h.assign(p.size(), 0.0);
    ClusterGrid<Dim> grid;
    grid.build(p.x, 0, p.size(), 0.2);
    CHECK(broken_rule(grid, p, 0, p.size(), 0.2) == "");
    std::size_t visits = 0;
    for (const std::size_t nowhere : {0, 7, 500}) {
        grid.build(p.x, nowhere, nowhere, 0.2, p.h);
        CHECK(grid.size() == 0);
        CHECK(grid.blocks() == 0);
        grid.blocks_near(Box<Dim>(p.x[0], p.x[0]), 1e3, 1, [&](std::size_t) { ++visits; });
    }
    ClusterGrid<Dim>{}.blocks_near(Box<Dim>(p.x[0], p.x[0]), 1e3, 1, [&](std::size_t) { ++visits; });
    CHECK(visits == 0);
}

TEMPLATE_TEST_CASE_SIG("clusters are the same for any number of threads", "[cluster_grid]", ((int Dim), Dim), 2, 3) {
    for (const auto& p : point_sets<Dim>()) {
        std::vector<std::vector<double>> grids;
        for (const int threads : {1, 2, 4}) {
            const ThreadScope scope(threads);
            ClusterGrid<Dim> grid;
            grid.build(p.x, 0, p.size(), 0.1, p.h);
            grids.push_back(contents(grid));
        }
        CAPTURE(p.size());
        CHECK((grids[1] == grids[0]));
        CHECK((grids[2] == grids[0]));
    }
}

TEMPLATE_TEST_CASE_SIG("clusters do not depend on the order in which particles stand", "[cluster_grid]",
                       ((int Dim), Dim), 2, 3) {
    Random random(5);
    for (const bool heaps : {false, true}) {  // without ties, which indices decide
        const auto x = heaps ? clustered_cloud<Dim>(4000, 1, random) : random_cloud<Dim>(4000, 1, random);
        ClusterGrid<Dim> grid;
        grid.build(x, 0, x.size(), 0.1);
        std::vector<std::size_t> itself(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) itself[i] = i;
        const auto expected = members(grid, itself);
        const auto order = shuffled(x.size(), random);
        const auto moved = reordered(x, order);
        grid.build(moved, 0, x.size(), 0.1);
        CAPTURE(heaps);
        CHECK((members(grid, order) == expected));
    }
}

TEMPLATE_TEST_CASE_SIG("particles in the grid's order are found in order", "[cluster_grid]", ((int Dim), Dim), 2, 3) {
    for (const auto& p : point_sets<Dim>()) {
        const std::size_t first = p.size() / 4;
        ClusterGrid<Dim> grid;
        grid.build(p.x, first, p.size(), 0.1, p.h);
        const auto before = contents(grid);
        std::vector<std::size_t> order(first);
        for (std::size_t i = 0; i < first; ++i) order[i] = i;
        order.insert(order.end(), grid.order().begin(), grid.order().end());
        const Points<Dim> sorted{reordered(p.x, order), reordered(p.h, order)};
        grid.particles_were_sorted(first);
        CAPTURE(p.size());
        CHECK(broken_rule(grid, sorted, first, p.size(), 0.1) == "");
        std::size_t out_of_order = 0;
        for (std::size_t t = 0; t < grid.size(); ++t) out_of_order += grid.particle(t) != first + t;
        CHECK(out_of_order == 0);
        const auto told = contents(grid);
        CHECK(std::equal(before.begin() + static_cast<std::ptrdiff_t>(grid.size()), before.end(),
                         told.begin() + static_cast<std::ptrdiff_t>(grid.size())));
        // Built anew, ties on a lattice and in a heap included, the grid is the same: lists run along memory.
        grid.build(sorted.x, first, p.size(), 0.1, sorted.h);
        CHECK((contents(grid) == told));
    }
}

TEMPLATE_TEST_CASE_SIG("on a lattice clusters are as compact as four particles can be", "[cluster_grid]",
                       ((int Dim), Dim), 2, 3) {
    const double d = 0.1;
    const int per_cell = Dim == 2 ? 8 : 4, per_axis = 3 * per_cell;  // 64 particles to a cell: one block
    auto x = lattice_points<Dim>(per_axis, d);
    Random random(6);
    x = reordered(x, shuffled(x.size(), random));
    ClusterGrid<Dim> grid;
    // Cells end just before a particle: at a multiple of d rounding would decide.
    grid.build(x, 0, x.size(), per_cell * d * (1 - 1e-9));
    std::size_t elongated = 0, clusters = 0;
    for (std::size_t b = 0; b < grid.blocks(); ++b)
        for (Index c = grid.clusters(b).begin; c < grid.clusters(b).end; ++c) {
            const Box<Dim>& box = grid.cluster_extent(c).box;
            ++clusters;
            for (int k = 0; k < Dim; ++k) elongated += box.hi[k] - box.lo[k] > 1.01 * d;
        }
    CHECK(clusters == x.size() / 4);
    CHECK(elongated == 0);
}

TEMPLATE_TEST_CASE_SIG("the blocks near a box hold every particle within its reach", "[cluster_grid]", ((int Dim), Dim),
                       2, 3) {
    Random random(7);
    for (const auto& p : point_sets<Dim>()) {
        ClusterGrid<Dim> grid;
        grid.build(p.x, 0, p.size(), 0.1, p.h);
        std::size_t missed = 0, twice = 0, needless = 0;
        for (int sample = 0; sample < 60; ++sample) {
            // Boxes around particles have ties on a lattice: a particle at the cut-off is out, as in the search.
            const auto corner = sample % 2 ? p.x[random.bits() % p.size()] : random.vector<Dim>(-0.5, 1.5);
            Box<Dim> box(corner, corner);
            if (sample % 3) box.add(corner + random.vector<Dim>(0, 0.2));
            const double cut = sample % 4 ? 0.1 / 3 : 0, scale = 0.5 * (sample % 5);
            std::vector<int> visits(grid.blocks(), 0);
            grid.blocks_near(box, cut, scale, [&](std::size_t b) { ++visits[b]; });
            for (std::size_t b = 0; b < grid.blocks(); ++b) {
                const Range clusters = grid.clusters(b);
                bool near = false;
                for (Index t = grid.particles(clusters.begin).begin; t < grid.particles(clusters.end - 1).end; ++t) {
                    const Index i = grid.particle(t);
                    const double limit = cut + scale * p.h[i];
                    near = near || distance2(box, Box<Dim>(p.x[i], p.x[i])) < limit * limit;
                }
                const double limit = cut + scale * grid.block_extent(b).max_reach;
                missed += near && visits[b] == 0;
                twice += visits[b] > 1;
                needless += visits[b] > 0 && !(distance2(box, grid.block_extent(b).box) < limit * limit);
            }
        }
        CAPTURE(p.size());
        CHECK(missed == 0);
        CHECK(twice == 0);
        CHECK(needless == 0);
    }
}

TEMPLATE_TEST_CASE_SIG("a cluster with a position that is not a number is measured by its others", "[cluster_grid]",
                       ((int Dim), Dim), 2, 3) {
    Random random(8);
    Points<Dim> p = points_of(random_cloud<Dim>(2000, 0.5, random), random);
    for (std::size_t i = 0; i < p.size(); i += 37) p.x.c[i % Dim][i] = std::numeric_limits<double>::quiet_NaN();
    ClusterGrid<Dim> grid;
    grid.build(p.x, 0, p.size(), 0.1, p.h);
    CHECK(broken_rule(grid, p, 0, p.size(), 0.1) == "");
    for (std::size_t b = 0; b < grid.blocks(); ++b)
        for (int k = 0; k < Dim; ++k) {
            REQUIRE_FALSE(std::isnan(grid.block_extent(b).box.lo[k]));
            REQUIRE_FALSE(std::isnan(grid.block_extent(b).box.hi[k]));
        }
}

}  // namespace sluice::test_cluster_grid
