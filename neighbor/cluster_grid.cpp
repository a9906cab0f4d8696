#include "neighbor/cluster_grid.hpp"

#include <algorithm>
#include <array>

#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

template <int Dim>
struct Member {
    Vec<Dim> x;
    Index i;
};

/// How many of n particles go to the first half: whole blocks, or whole clusters once there is one block only.
Index first_half(Index n) {
    const Index clusters = (n + cluster_size - 1) / cluster_size;
    const Index blocks = (clusters + block_size - 1) / block_size;
    const Index half = blocks > 1 ? (blocks + 1) / 2 * block_size : (clusters + 1) / 2;
    return half * cluster_size;
}

/// Sorts members so that clusters follow each other: halves along the longest extent, again and again. Particles at the
/// same coordinate keep to the order of their indices: the result is the same for any order of the members.
template <int Dim>
void halve(std::span<Member<Dim>> members) {
    if (members.size() <= cluster_size) {
        std::sort(members.begin(), members.end(), [](const auto& a, const auto& b) { return a.i < b.i; });
        return;
    }
    Box<Dim> box;
    for (const auto& m : members) box.add(m.x);
    int axis = 0;
    for (int k = 1; k < Dim; ++k)
        if (box.hi[k] - box.lo[k] > box.hi[axis] - box.lo[axis]) axis = k;
    const auto half = first_half(static_cast<Index>(members.size()));
    std::nth_element(members.begin(), members.begin() + half, members.end(), [axis](const auto& a, const auto& b) {
        return a.x[axis] < b.x[axis] || (a.x[axis] == b.x[axis] && a.i < b.i);
    });
    halve(members.first(half));
    halve(members.subspan(half));
}

}  // namespace

template <int Dim>
void ClusterGrid<Dim>::build(const VectorField<Dim>& position, std::size_t first, std::size_t last, double cell_size,
                             std::span<const double> reach) {
    cells_.build(position, first, last, cell_size, reach);
    size_ = last - first;
    sorted_ = false;
    const auto& cells = cells_.cells();
    cell_block_.resize(cells.size() + 1);
    cell_cluster_.resize(cells.size() + 1);
    Index clusters = 0, blocks = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        cell_cluster_[c] = clusters;
        cell_block_[c] = blocks;
        const Index in_cell = (cells[c].end - cells[c].begin + cluster_size - 1) / cluster_size;
        clusters += in_cell;
        blocks += (in_cell + block_size - 1) / block_size;
    }
    cell_cluster_[cells.size()] = clusters;
    cell_block_[cells.size()] = blocks;
    cluster_start_.resize(clusters + 1);
    cluster_start_[clusters] = static_cast<Index>(size());
    block_.resize(blocks);
    parallel_for_heavy(cells.size(), [&](std::size_t c) { cut_cell(position, c); });
    measure(position, reach);
}

template <int Dim>
void ClusterGrid<Dim>::cut_cell(const VectorField<Dim>& position, std::size_t cell) {
    Array<Index>& order = cells_.order();
    const Cell<Dim>& c = cells_.cells()[cell];
    constexpr std::size_t usual = 512;
    std::array<Member<Dim>, usual> on_stack;
    std::vector<Member<Dim>> on_heap;
    const std::size_t n = c.end - c.begin;
    if (n > usual) on_heap.resize(n);
    const std::span<Member<Dim>> members(n > usual ? on_heap.data() : on_stack.data(), n);
    for (std::size_t m = 0; m < n; ++m) {
        const Index i = order[c.begin + m];
        members[m] = {position[i], i};
        for (double& x : members[m].x.c) x = x == x ? x : 0.0;  // what is not a number cannot be sorted
    }
    halve(members);
    for (std::size_t m = 0; m < n; ++m) order[c.begin + m] = members[m].i;
    for (Index k = cell_cluster_[cell]; k < cell_cluster_[cell + 1]; ++k)
        cluster_start_[k] = c.begin + (k - cell_cluster_[cell]) * cluster_size;
    for (Index b = cell_block_[cell]; b < cell_block_[cell + 1]; ++b) {
        const Index begin = cell_cluster_[cell] + (b - cell_block_[cell]) * block_size;
        block_[b] = {begin, std::min(begin + block_size, cell_cluster_[cell + 1])};
    }
}

template <int Dim>
void ClusterGrid<Dim>::measure(const VectorField<Dim>& position, std::span<const double> reach) {
    cluster_extent_.resize(cluster_start_.size() - 1);
    block_extent_.resize(block_.size());
    parallel_for_heavy(block_.size(), [&](std::size_t b) {
        block_extent_[b] = {};
        for (Index c = block_[b].begin; c < block_[b].end; ++c) {
            Extent<Dim> extent;
            for (Index t = cluster_start_[c]; t < cluster_start_[c + 1]; ++t) {
                const Index i = order()[t];
                const double r = reach.empty() ? 0.0 : reach[i];
                extent.add({{position[i], position[i]}, r, r});
            }
            cluster_extent_[c] = extent;
            block_extent_[b].add(extent);
        }
    });
}

template <int Dim>
void ClusterGrid<Dim>::particles_were_sorted(std::size_t first) {
    sorted_ = true;
    first_ = static_cast<Index>(first);
    Array<Index>().swap(cells_.order());
}

template <int Dim>
std::size_t ClusterGrid<Dim>::bytes() const {
    return cells_.bytes() +
           (cell_block_.capacity() + cell_cluster_.capacity() + cluster_start_.capacity()) * sizeof(Index) +
           block_.capacity() * sizeof(Range) +
           (cluster_extent_.capacity() + block_extent_.capacity()) * sizeof(Extent<Dim>);
}

template class ClusterGrid<2>;
template class ClusterGrid<3>;

}  // namespace sluice
