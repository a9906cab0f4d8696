// Cell-linked lists: particles sorted by the Morton key of the cell that they lie in.
//
// Only occupied cells exist; they are found through a hash table of their keys. Memory therefore follows the number of
// particles, not the extent of the domain, and a particle that flies far away costs nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "neighbor/box.hpp"
#include "neighbor/fields.hpp"

namespace sluice {

/// An occupied cell: its particles are order()[begin, end).
template <int Dim>
struct Cell {
    std::array<std::uint32_t, Dim> coordinate{};
    Index begin = 0;
    Index end = 0;
    double reach = 0;  ///< largest reach of its particles [m]
};

template <int Dim>
class CellGrid {
  public:
    /// Sorts the positions first … last − 1 into cells of the given edge. `reach` (a column, or empty = 0) is each
    /// particle's share of a pair's cut-off. Throws std::length_error if the extent over the cell size exceeds the
    /// key's range.
    void build(const VectorField<Dim>& position, std::size_t first, std::size_t last, double cell_size,
               std::span<const double> reach = {});

    /// Particle indices, cell by cell in Morton order; within a cell ascending.
    const Array<Index>& order() const { return order_; }
    /// Mutable, so that ClusterGrid can sort within each cell.
    Array<Index>& order() { return order_; }
    const Array<Cell<Dim>>& cells() const { return cells_; }
    double cell_size() const { return cell_size_; }
    const Vec<Dim>& origin() const { return origin_; }
    double max_reach() const { return max_reach_; }

    /// Cell at a coordinate (which may lie outside the grid), or nullptr if no particle is in it.
    const Cell<Dim>* find(const std::array<std::int64_t, Dim>& coordinate) const;

    /// visit(number of the cell) for every cell that may hold a particle closer to the box than `cut` plus `scale`
    /// times its own reach, x fastest.
    template <class Visit>
    void cells_near(const Box<Dim>& box, double cut, double scale, Visit&& visit) const;

    std::size_t bytes() const;

    /// visit(name, member) for each member: a copy of them all is the same grid.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("cell_size", cell_size_), visit("max_reach", max_reach_), visit("origin", origin_.c);
        visit("extent", extent_), visit("key_bits", key_bits_), visit("order", order_), visit("cells", cells_);
        visit("cell_key", cell_key_), visit("table", table_);
    }

  private:
    void compute_keys(const VectorField<Dim>& position, std::size_t first, std::size_t last,
                      Array<std::uint64_t>& keys);
    std::array<std::uint32_t, Dim> cell_of(const VectorField<Dim>& position, std::size_t i) const;
    void collect_cells(const VectorField<Dim>& position, std::span<const double> reach,
                       const Array<std::uint64_t>& keys);
    void hash_cells();

    double cell_size_ = 0;
    double max_reach_ = 0;
    Vec<Dim> origin_;
    std::array<std::uint32_t, Dim> extent_{};  ///< cells along each axis
    int key_bits_ = 0;
    Array<Index> order_;
    Array<Cell<Dim>> cells_;
    Array<std::uint64_t> cell_key_;
    Array<Index> table_;  ///< open addressing, size a power of two: cell number + 1, 0 = empty
};

template <int Dim>
template <class Visit>
void CellGrid<Dim>::cells_near(const Box<Dim>& box, double cut, double scale, Visit&& visit) const {
    const double farthest = cut + scale * max_reach_;
    std::array<std::int64_t, Dim> first, last, c;
    for (std::size_t k = 0; k < Dim; ++k) {
        const int axis = static_cast<int>(k);
        // Clamped, so that no distance is too far to be numbered.
        const auto number = [&](double x) {
            return static_cast<std::int64_t>(
                std::clamp(std::floor((x - origin_[axis]) / cell_size_), -1.0, extent_[k] + 1.0));
        };
        // Edges of cells are known up to rounding only: a cell that is missed by that much is looked at too.
        first[k] = std::max<std::int64_t>(number(box.lo[axis] - farthest * (1 + 1e-9)), 0);
        last[k] = std::min<std::int64_t>(number(box.hi[axis] + farthest * (1 + 1e-9)), extent_[k] - 1);
        if (first[k] > last[k]) return;
    }
    c = first;
    for (;;) {
        if (const Cell<Dim>* cell = find(c)) visit(static_cast<std::size_t>(cell - cells_.data()));
        std::size_t k = 0;
        while (k < Dim && ++c[k] > last[k]) {
            c[k] = first[k];
            ++k;
        }
        if (k == Dim) return;
    }
}

extern template class CellGrid<2>;
extern template class CellGrid<3>;

}  // namespace sluice
