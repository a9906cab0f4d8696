// A cell grid whose cells are cut into clusters: four particles that lie close together.
//
// Loops over pairs go cluster against cluster: 4 × 4 pairs in one or a few vector registers, without an index per
// particle. How many of those pairs are wasted depends on how compact clusters are: a cell's particles are halved at
// the median along their longest extent until four are left, which wastes a third less in three dimensions than four
// that follow each other on the Morton curve (bench/README.md).
#pragma once

#include <cstdint>
#include <span>

#include "neighbor/box.hpp"
#include "neighbor/cell_grid.hpp"

namespace sluice {

/// Particles in a cluster. All clusters of a cell but its last are full.
inline constexpr Index cluster_size = 4;
/// Clusters in a block, which shares one list of candidates. All blocks of a cell but its last are full.
inline constexpr Index block_size = 16;

/// A run of the grid's order, or of something that follows it.
struct Range {
    Index begin = 0, end = 0;
    Index size() const { return end - begin; }
};

/// What is known of a cluster, a block or a cell.
template <int Dim>
struct Extent {
    Box<Dim> box;
    double min_reach = std::numeric_limits<double>::infinity(), max_reach = 0;

    void add(const Extent& e) {
        box.add(e.box);
        min_reach = e.min_reach < min_reach ? e.min_reach : min_reach;
        max_reach = e.max_reach > max_reach ? e.max_reach : max_reach;
    }
};

template <int Dim>
class ClusterGrid {
  public:
    /// Sorts the positions first … last − 1 into cells of the given edge, in Morton order, and cuts the cells.
    /// `reach` (a column, or empty = 0) is each particle's share of a pair's cut-off.
    /// Throws std::length_error as CellGrid does.
    void build(const VectorField<Dim>& position, std::size_t first, std::size_t last, double cell_size,
               std::span<const double> reach = {});

    /// Particle indices: cell by cell in Morton order, block by block, cluster by cluster. Gone once particles stand in
    /// that order themselves.
    const Array<Index>& order() const { return cells_.order(); }
    std::size_t size() const { return size_; }
    /// The particle at a place of the order.
    Index particle(std::size_t place) const {
        return sorted_ ? first_ + static_cast<Index>(place) : order()[place];
    }

    /// To be told when the particles have been brought into the grid's order: it is then first, first + 1, …, and needs
    /// no memory.
    void particles_were_sorted(std::size_t first);
    bool is_sorted() const { return sorted_; }

    std::size_t blocks() const { return block_.size(); }
    /// Clusters of a block.
    Range clusters(std::size_t block) const { return block_[block]; }
    /// Particles of a cluster, as a range of the order.
    Range particles(std::size_t cluster) const { return {cluster_start_[cluster], cluster_start_[cluster + 1]}; }
    const Extent<Dim>& block_extent(std::size_t block) const { return block_extent_[block]; }
    const Extent<Dim>& cluster_extent(std::size_t cluster) const { return cluster_extent_[cluster]; }

    /// visit(b) for every block that may hold a particle closer to the box than `cut` plus `scale` times its
    /// own reach, cell by cell.
    template <class Visit>
    void blocks_near(const Box<Dim>& box, double cut, double scale, Visit&& visit) const;

    std::size_t bytes() const;

    /// visit(name, member) for each member: a copy of them all is the same grid.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("cells", cells_), visit("cell_block", cell_block_), visit("cell_cluster", cell_cluster_);
        visit("block", block_), visit("cluster_start", cluster_start_), visit("cluster_extent", cluster_extent_);
        visit("block_extent", block_extent_), visit("size", size_), visit("sorted", sorted_), visit("first", first_);
    }

  private:
    void cut_cell(const VectorField<Dim>& position, std::size_t cell);
    void measure(const VectorField<Dim>& position, std::span<const double> reach);

    CellGrid<Dim> cells_;
    std::uint64_t size_ = 0;
    bool sorted_ = false;
    Index first_ = 0;                ///< particle, if they are sorted
    Array<Index> cell_block_{0};     ///< first block of each cell
    Array<Index> cell_cluster_{0};   ///< first cluster of each cell
    Array<Range> block_;             ///< clusters
    Array<Index> cluster_start_{0};  ///< in the order
    Array<Extent<Dim>> cluster_extent_, block_extent_;
};

template <int Dim>
template <class Visit>
void ClusterGrid<Dim>::blocks_near(const Box<Dim>& box, double cut, double scale, Visit&& visit) const {
    if (size() == 0) return;
    cells_.cells_near(box, cut, scale, [&](std::size_t cell) {
        for (Index b = cell_block_[cell]; b < cell_block_[cell + 1]; ++b) {
            const double limit = cut + scale * block_extent_[b].max_reach;
            if (distance2(box, block_extent_[b].box) < limit * limit) visit(static_cast<std::size_t>(b));
        }
    });
}

extern template class ClusterGrid<2>;
extern template class ClusterGrid<3>;

}  // namespace sluice
