// A block's candidates, gathered once into the first-level cache and then read cluster by cluster.
//
// Only for files that are compiled once per instruction set.
#pragma once

#include "kernels/pairs/particle_view.hpp"
#include "neighbor/neighbor_list.hpp"
#include "neighbor/pack.hpp"

namespace sluice::SLUICE_ISA {

/// Four particles, column by column. Positions are kept relative to an origin near the block, formed in double and then
/// rounded: single precision stays accurate far from the scene's origin.
///
/// Missing particles are copies of the first one, moved out of every support and without mass or volume: every term of
/// theirs is finite and zero.
template <int Dim, class Number, ColumnSet Reads>
struct alignas(4 * sizeof(Number)) Four {
    using Slot = Slots<Dim, Reads>;

    Number value[Slot::count][4];

    SLUICE_INLINE void gather(const ListedCluster& c, const Index* index, const typename Slot::Pointers& columns,
                              const double (&origin)[Slot::count]) {
        if (c.in_sequence && c.size == 4) {
            for (int s = 0; s < Slot::count; ++s) {
                const double* from = columns[static_cast<std::size_t>(s)] + c.first;
                for (int l = 0; l < 4; ++l) value[s][l] = static_cast<Number>(from[l] - origin[s]);
            }
            return;
        }
        for (int l = 0; l < 4; ++l) {
            const Index i = c.particle(static_cast<Index>(l), index);
            for (int s = 0; s < Slot::count; ++s)
                value[s][l] = static_cast<Number>(columns[static_cast<std::size_t>(s)][i] - origin[s]);
            if (l < c.size) continue;
            value[0][l] += Number(1e4) * value[Slot::smoothing_length][l];
            if constexpr (Reads.has(Column::mass)) value[Slot::of(Column::mass)][l] = 0;
            if constexpr (Reads.has(Column::volume)) value[Slot::of(Column::volume)][l] = 0;
        }
    }
};

/// One side's columns, a register of each.
template <int Dim, class Real_, ColumnSet Reads>
struct Side {
    using Real = Real_;
    using Slot = Slots<Dim, Reads>;

    Real value[Slot::count];

    /// The value of a column: a number, vector or tensor.
    template <Column C>
    SLUICE_INLINE auto get() const {
        static_assert(Reads.has(C), "a term reads a column that it does not name");
        if constexpr (info_of(C).rank == Rank::scalar) {
            return value[Slot::of(C)];
        } else {
            Vec<Slot::width(C), Real> v;
            unroll<Slot::width(C)>([&](int k) __attribute__((always_inline)) { v[k] = value[Slot::of(C) + k]; });
            return v;
        }
    }
    SLUICE_INLINE Vec<Dim, Real> place() const {
        Vec<Dim, Real> v;
        unroll<Dim>([&](int k) __attribute__((always_inline)) { v[k] = value[k]; });
        return v;
    }
    SLUICE_INLINE Real smoothing_length() const { return value[Slot::smoothing_length]; }
};

}  // namespace sluice::SLUICE_ISA
