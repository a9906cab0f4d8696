#include "neighbor/cell_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "neighbor/morton.hpp"
#include "neighbor/parallel.hpp"
#include "neighbor/radix_sort.hpp"

namespace sluice {
namespace {

/// Fibonacci hashing: the upper bits of key × 2^64/φ.
std::size_t slot_of(std::uint64_t key, std::size_t mask) {
    return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> 32) & mask;
}

/// The box around the positions first … last − 1 that are numbers.
template <int Dim>
Box<Dim> extent_of(const VectorField<Dim>& position, std::size_t first, std::size_t last) {
    Box<Dim> box;
    for (std::size_t i = first; i < last; ++i) box.add(position[i]);
    return box;
}

}  // namespace

template <int Dim>
void CellGrid<Dim>::build(const VectorField<Dim>& position, std::size_t first, std::size_t last, double cell_size,
                          std::span<const double> reach) {
    const std::size_t n = last - first;
    cell_size_ = cell_size;
    cells_.clear();
    cell_key_.clear();
    Array<std::uint64_t> keys(n);
    order_.resize(n);
    max_reach_ = 0;
    if (n > 0) {
        compute_keys(position, first, last, keys);
        radix_sort(keys, order_, key_bits_);
        collect_cells(position, reach, keys);
    }
    hash_cells();
}

template <int Dim>
void CellGrid<Dim>::compute_keys(const VectorField<Dim>& position, std::size_t first, std::size_t last,
                                 Array<std::uint64_t>& keys) {
    const Box<Dim> box = extent_of(position, first, last);
    int bits = 1;
    for (int k = 0; k < Dim; ++k) {
        const double cells = std::floor((box.hi[k] - box.lo[k]) / cell_size_) + 1;
        if (!(cells >= 1 && cells < std::ldexp(1.0, morton_bits<Dim>)))
            throw std::length_error("the particles are spread over more cells than a sorting key can number");
        origin_[k] = box.lo[k];
        extent_[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(cells);
        bits = std::max(bits, static_cast<int>(std::bit_width(extent_[static_cast<std::size_t>(k)] - 1)));
    }
    key_bits_ = bits * Dim;
    parallel_for(last - first, [&](std::size_t k) {
        keys[k] = morton_encode<Dim>(cell_of(position, first + k));
        order_[k] = static_cast<Index>(first + k);
    });
}

template <int Dim>
std::array<std::uint32_t, Dim> CellGrid<Dim>::cell_of(const VectorField<Dim>& position, std::size_t i) const {
    std::array<std::uint32_t, Dim> cell;
    const double per_cell = 1 / cell_size_;
    for (std::size_t k = 0; k < Dim; ++k) {
        const double c = (position.c[k][i] - origin_[static_cast<int>(k)]) * per_cell;
        // x·(1/a) may round up to the next whole number. A position that is not a number goes into the first cell.
        cell[k] = c > 0 ? static_cast<std::uint32_t>(std::min(c, static_cast<double>(extent_[k] - 1))) : 0;
    }
    return cell;
}

template <int Dim>
void CellGrid<Dim>::collect_cells(const VectorField<Dim>& position, std::span<const double> reach,
                                  const Array<std::uint64_t>& keys) {
    const std::size_t n = keys.size();
    for (std::size_t begin = 0; begin < n;) {
        Cell<Dim> cell;
        cell.coordinate = cell_of(position, order_[begin]);
        std::size_t end = begin;
        for (; end < n && keys[end] == keys[begin]; ++end)
            if (!reach.empty()) cell.reach = std::max(cell.reach, reach[order_[end]]);
        cell.begin = static_cast<Index>(begin);
        cell.end = static_cast<Index>(end);
        cells_.push_back(cell);
        cell_key_.push_back(keys[begin]);
        max_reach_ = std::max(max_reach_, cell.reach);
        begin = end;
    }
}

template <int Dim>
void CellGrid<Dim>::hash_cells() {
    const std::size_t slots = std::bit_ceil(std::max<std::size_t>(2 * cells_.size(), 2));
    table_.assign(slots, 0);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        std::size_t s = slot_of(cell_key_[c], slots - 1);
        while (table_[s] != 0) s = (s + 1) & (slots - 1);
        table_[s] = static_cast<Index>(c + 1);
    }
}

template <int Dim>
const Cell<Dim>* CellGrid<Dim>::find(const std::array<std::int64_t, Dim>& coordinate) const {
    std::array<std::uint32_t, Dim> cell;
    for (std::size_t k = 0; k < Dim; ++k) {
        if (coordinate[k] < 0 || coordinate[k] >= static_cast<std::int64_t>(extent_[k])) return nullptr;
        cell[k] = static_cast<std::uint32_t>(coordinate[k]);
    }
    const std::uint64_t key = morton_encode<Dim>(cell);
    for (std::size_t s = slot_of(key, table_.size() - 1); table_[s] != 0; s = (s + 1) & (table_.size() - 1))
        if (cell_key_[table_[s] - 1] == key) return &cells_[table_[s] - 1];
    return nullptr;
}

template <int Dim>
std::size_t CellGrid<Dim>::bytes() const {
    return cell_key_.capacity() * sizeof(std::uint64_t) + (order_.capacity() + table_.capacity()) * sizeof(Index) +
           cells_.capacity() * sizeof(Cell<Dim>);
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace sluice
