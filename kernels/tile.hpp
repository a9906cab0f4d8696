// A block's candidates, gathered once into the first-level cache and then read cluster by cluster.
//
// Only for files that are compiled once per instruction set.
#pragma once

#include "kernels/columns.hpp"
#include "neighbor/neighbor_list.hpp"
#include "neighbor/pack.hpp"

namespace sluice::SLUICE_ISA {

/// Four particles, column by column. Positions are kept relative to an origin near the block, formed in double and then
/// rounded: single precision stays accurate far from the scene's origin.
///
/// Missing particles are copies of the first one, moved out of every support and without mass or volume: every term is
/// zero there, and finite.
template <int Dim, class Number, unsigned Reads>
struct alignas(4 * sizeof(Number)) Four {
    using Slot = Slots<Dim, Reads>;
    using Columns = std::array<const double*, static_cast<std::size_t>(Slot::count)>;

    Number value[Slot::count][4];

    SLUICE_INLINE void gather(const ListedCluster& c, const Index* index, const Columns& columns,
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
            if constexpr (Reads & column::mass) value[Slot::of(column::mass)][l] = 0;
            if constexpr (Reads & column::volume) value[Slot::of(column::volume)][l] = 0;
        }
    }
};

/// A register's worth of one side's columns.
template <int Dim, class Real_, unsigned Reads>
struct Side {
    using Real = Real_;
    using Slot = Slots<Dim, Reads>;

    Real value[Slot::count];

    template <unsigned C>
    SLUICE_INLINE Real scalar() const {
        static_assert(Reads & C, "a term reads a column that it does not name");
        return value[Slot::of(C)];
    }
    template <unsigned C>
    SLUICE_INLINE Vec<Slot::width(C), Real> tuple() const {
        static_assert(Reads & C, "a term reads a column that it does not name");
        Vec<Slot::width(C), Real> v;
        unroll<Slot::width(C)>([&](int k) __attribute__((always_inline)) { v[k] = value[Slot::of(C) + k]; });
        return v;
    }
    SLUICE_INLINE Vec<Dim, Real> position() const {
        Vec<Dim, Real> v;
        unroll<Dim>([&](int k) __attribute__((always_inline)) { v[k] = value[k]; });
        return v;
    }
    SLUICE_INLINE Real smoothing_length() const { return value[Slot::smoothing_length]; }
};

}  // namespace sluice::SLUICE_ISA
