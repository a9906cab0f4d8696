// Cell grids: every particle in exactly one cell, found again, whatever the cloud.
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "neighbor/cell_grid.hpp"
#include "neighbor/morton.hpp"
#include "tests/catch.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_cell_grid {

namespace {

/// What holds for every grid of the positions first … last − 1; the first broken rule by name, or "".
template <int Dim>
std::string broken_rule(const CellGrid<Dim>& grid, const VectorField<Dim>& x, std::size_t first, std::size_t last,
                        std::span<const double> reach = {}) {
    const std::size_t n = last - first;
    if (grid.order().size() != n) return "order has an entry for each position";
    std::vector<int> seen(last, 0);
    for (const Index i : grid.order())
        if (i < first || i >= last || seen[i]++) return "order is a permutation";
    Index next = 0;
    double max_reach = 0;
    std::uint64_t last_key = 0;
    for (const auto& cell : grid.cells()) {
        if (cell.begin != next || cell.end <= cell.begin) return "cells follow each other and none is empty";
        next = cell.end;
        const std::uint64_t key = morton_encode<Dim>(cell.coordinate);
        if (&cell != &grid.cells()[0] && key <= last_key) return "keys ascend";
        last_key = key;
        double largest = 0;
        for (Index t = cell.begin; t < cell.end; ++t) {
            const Index i = grid.order()[t];
            if (t > cell.begin && i <= grid.order()[t - 1]) return "indices ascend within a cell";
            if (!reach.empty()) largest = std::max(largest, reach[i]);
            for (int k = 0; k < Dim; ++k) {
                // Coordinates are quotients: they are off by a few units in the last place of the extent.
                const double c = (x[i][k] - grid.origin()[k]) / grid.cell_size();
                const double lo = cell.coordinate[static_cast<std::size_t>(k)], slack = 1e-15 * (1 + c);
                if (!(c >= lo - slack && c <= lo + 1 + slack)) return "a particle lies in its cell";
            }
        }
        if (cell.reach != largest) return "a cell's reach is the largest of its particles";
        max_reach = std::max(max_reach, largest);
        std::array<std::int64_t, Dim> at;
        std::copy(cell.coordinate.begin(), cell.coordinate.end(), at.begin());
        if (grid.find(at) != &cell) return "find() finds every cell";
    }
    if (next != n) return "every particle is in a cell";
    return grid.max_reach() == max_reach ? "" : "max_reach is the largest reach";
}

/// find() returns a cell exactly at the coordinates that the list of cells has, over a box with a margin.
template <int Dim>
bool finds_nothing_else(const CellGrid<Dim>& grid, std::int64_t per_axis) {
    std::size_t found = 0;
    for (std::int64_t z = Dim == 3 ? -2 : 0; z < (Dim == 3 ? per_axis : 1); ++z)
        for (std::int64_t y = -2; y < per_axis; ++y)
            for (std::int64_t x = -2; x < per_axis; ++x) {
                std::array<std::int64_t, Dim> at{x, y};
                if (Dim == 3) at[Dim - 1] = z;
                const Cell<Dim>* cell = grid.find(at);
                if (!cell) continue;
                ++found;
                if (!std::equal(at.begin(), at.end(), cell->coordinate.begin())) return false;
            }
    return found == grid.cells().size();
}

/// The cells that cells_near visits, by number, in its order.
template <int Dim>
std::vector<std::size_t> visited(const CellGrid<Dim>& grid, const Box<Dim>& box, double cut, double scale = 1) {
    std::vector<std::size_t> cells;
    grid.cells_near(box, cut, scale, [&](std::size_t cell) { cells.push_back(cell); });
    return cells;
}

/// What holds for a visit of the cells near a box; the first broken rule by name, or "".
template <int Dim>
std::string broken_visit(const CellGrid<Dim>& grid, const VectorField<Dim>& x, std::span<const double> reach,
                         const Box<Dim>& box, double cut, double scale) {
    const auto cells = visited(grid, box, cut, scale);
    for (std::size_t n = 1; n < cells.size(); ++n) {
        const auto &a = grid.cells()[cells[n - 1]].coordinate, &b = grid.cells()[cells[n]].coordinate;
        if (!std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend())) return "x is fastest";
    }
    for (std::size_t c = 0; c < grid.cells().size(); ++c) {
        bool near = false;
        for (Index t = grid.cells()[c].begin; t < grid.cells()[c].end; ++t) {
            const Index i = grid.order()[t];
            const double limit = cut + scale * reach[i];
            near = near || distance2(box, Box<Dim>(x[i], x[i])) < limit * limit;
        }
        if (near && std::find(cells.begin(), cells.end(), c) == cells.end()) return "a cell with a particle in reach";
    }
    return "";
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("every particle stands in exactly one cell", "[cell_grid]", ((int Dim), Dim), 2, 3) {
    CellGrid<Dim> grid;  // one for all: buffers and the hash table are reused
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        Random random(2);
        for (const std::size_t n : {1, 2, 37, 3000, 20000}) {
            const auto x = random_cloud<Dim>(n, 1, random);
            const auto h = random_reach(n, 0.01, random);
            CAPTURE(threads, n);
            grid.build(x, 0, n, 0.05, h);
            CHECK(broken_rule<Dim>(grid, x, 0, n, h) == "");
            CHECK(finds_nothing_else<Dim>(grid, 24));
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a lattice whose points lie on the cells' edges", "[cell_grid]", ((int Dim), Dim), 2, 3) {
    for (const double d : {0.1, 1.0 / 3, 0.005 / 6, 1e-9}) {
        const auto x = lattice_points<Dim>(17, d);
        CellGrid<Dim> grid;
        CAPTURE(d);
        for (const double cells : {0.5, 1.0, 2.0, 3.0}) {
            grid.build(x, 0, x.size(), cells * d);
            CHECK(broken_rule<Dim>(grid, x, 0, x.size()) == "");
        }
    }
}

TEMPLATE_TEST_CASE_SIG("only the positions of the range count", "[cell_grid]", ((int Dim), Dim), 2, 3) {
    Random random(3);
    auto x = random_cloud<Dim>(5000, 1, random);
    auto h = random_reach(5000, 0.01, random);
    for (const std::size_t outside : {0, 99, 4900}) {
        x.set(outside, random.vector<Dim>(1e30, 2e30));
        h[outside] = 1e30;
    }
    CellGrid<Dim> grid;
    for (const int threads : {1, 2}) {
        const ThreadScope scope(threads);
        for (const std::size_t first : {100, 1300, 4899}) {
            CAPTURE(threads, first);
            grid.build(x, first, 4900, 0.1, h);
            CHECK(broken_rule<Dim>(grid, x, first, 4900, h) == "");
            grid.build(x, first, 4900, 0.1);
            CHECK(broken_rule<Dim>(grid, x, first, 4900) == "");
            CHECK(grid.max_reach() == 0);
        }
    }
    grid.build(x, 4900, 4900, 0.1, h);
    CHECK(grid.order().empty());
}

TEMPLATE_TEST_CASE_SIG("the cells near a box hold every particle within its reach", "[cell_grid]", ((int Dim), Dim), 2,
                       3) {
    Random random(6);
    const std::size_t n = 2000;
    for (const bool on_edges : {false, true}) {
        const auto x = on_edges ? lattice_points<Dim>(Dim == 2 ? 40 : 12, 0.1) : clustered_cloud<Dim>(n, 1, random);
        const auto h = random_reach(x.size(), 0.02, random);
        CellGrid<Dim> grid;
        grid.build(x, 0, x.size(), on_edges ? 0.2 : 0.07, h);
        for (int sample = 0; sample < 300; ++sample) {
            Box<Dim> box;
            const auto corner = on_edges ? x[random.bits() % x.size()] : random.vector<Dim>(-0.5, 1.5);
            box.add(corner);
            if (sample % 3) box.add(corner + random.vector<Dim>(0, 0.3));
            const double cut = sample % 2 ? 0 : random.in(0, 0.3), scale = 0.5 * (sample % 5);
            CAPTURE(on_edges, sample);
            CHECK(broken_visit<Dim>(grid, x, h, box, cut, scale) == "");
        }
        // Of a box that takes in everything, one that lies far away, and one around nothing.
        CHECK(visited(grid, Box<Dim>(x[0], x[0]), 100.0).size() == grid.cells().size());
        Vec<Dim> away;
        away[Dim - 1] = -1e12;
        CHECK(visited(grid, Box<Dim>(away, away), 1.0).empty());
        CHECK(visited(grid, Box<Dim>(), 1.0).empty());
    }
}

TEMPLATE_TEST_CASE_SIG("a position that is not a number is kept, and moves no other", "[cell_grid]", ((int Dim), Dim),
                       2, 3) {
    Random random(8);
    const auto x = random_cloud<Dim>(1000, 1, random);
    auto broken = x;
    broken.c[0][0] = broken.c[Dim - 1][500] = broken.c[1][999] = std::numeric_limits<double>::quiet_NaN();
    CellGrid<Dim> grid;
    grid.build(broken, 0, 1000, 0.1);
    std::vector<Index> order(grid.order().begin(), grid.order().end());
    std::sort(order.begin(), order.end());
    for (Index i = 0; i < 1000; ++i) REQUIRE(order[i] == i);
    for (const auto& cell : grid.cells())
        for (Index t = cell.begin; t < cell.end; ++t) {
            const Vec<Dim> at = broken[grid.order()[t]];
            if (!(norm2(at) < 100)) continue;
            for (int k = 0; k < Dim; ++k)
                REQUIRE(std::floor((at[k] - grid.origin()[k]) / 0.1) == cell.coordinate[static_cast<std::size_t>(k)]);
        }
}

TEMPLATE_TEST_CASE_SIG("a particle far away costs nothing", "[cell_grid]", ((int Dim), Dim), 2, 3) {
    Random random(4);
    auto x = random_cloud<Dim>(1000, 1, random);
    Vec<Dim> away;
    away[0] = 1e6;  // [m]
    x.set(500, away);
    x.set(501, -1.0 * away);
    CellGrid<Dim> grid;
    // The key has 32 bits per axis in the plane, 21 in space.
    const double cell = Dim == 2 ? 0.01 : 1.0;
    grid.build(x, 0, x.size(), cell);
    CHECK(broken_rule<Dim>(grid, x, 0, x.size()) == "");
    CHECK(grid.cells().size() <= 1000);
    CHECK(grid.find(std::array<std::int64_t, Dim>{1}) == nullptr);  // between the first and the crowd
}

TEMPLATE_TEST_CASE_SIG("an extent that no key can number is refused", "[cell_grid]", ((int Dim), Dim), 2, 3) {
    VectorField<Dim> x;
    x.push_back({});
    CellGrid<Dim> grid;
    const double limit = std::ldexp(1.0, morton_bits<Dim>);
    for (const double far : {limit, 1e30, std::numeric_limits<double>::infinity()}) {
        Vec<Dim> away;
        away[Dim - 1] = far;
        x.resize(1);
        x.push_back(away);
        CAPTURE(far);
        CHECK_THROWS_AS(grid.build(x, 0, 2, 1.0), std::length_error);
    }
    Vec<Dim> last;
    last[Dim - 1] = limit - 2;
    x.set(1, last);
    grid.build(x, 0, 2, 1.0);
    CHECK(broken_rule<Dim>(grid, x, 0, 2) == "");
}

TEMPLATE_TEST_CASE_SIG("all particles at one point share one cell", "[cell_grid]", ((int Dim), Dim), 2, 3) {
    VectorField<Dim> x;
    for (int i = 0; i < 5000; ++i) x.push_back(Random(9).vector<Dim>(-3, 3));
    CellGrid<Dim> grid;
    grid.build(x, 0, x.size(), 0.1);
    CHECK(broken_rule<Dim>(grid, x, 0, x.size()) == "");
    CHECK(grid.cells().size() == 1);
    CHECK(finds_nothing_else<Dim>(grid, 3));
}

TEMPLATE_TEST_CASE_SIG("a grid of nothing, also after one of something", "[cell_grid]", ((int Dim), Dim), 2, 3) {
    CellGrid<Dim> grid;
    const VectorField<Dim> none;
    grid.build(none, 0, 0, 0.1);
    CHECK(grid.cells().empty());
    CHECK(grid.find(std::array<std::int64_t, Dim>{}) == nullptr);
    Random random(5);
    const auto x = random_cloud<Dim>(100, 1, random);
    const auto h = random_reach(100, 0.1, random);
    grid.build(x, 0, x.size(), 0.1, h);
    grid.build(none, 0, 0, 0.1);
    CHECK(grid.order().empty());
    CHECK(grid.cells().empty());
    CHECK(grid.max_reach() == 0);
    CHECK(grid.find(std::array<std::int64_t, Dim>{}) == nullptr);
}

}  // namespace sluice::test_cell_grid
