// The loop over pairs, written once: each particle gathers from its own partners, in the list's order, so that the sums
// have the same bits for any number of threads.
//
// A block's candidates are gathered once into a tile. Each of its clusters then meets the clusters of its row: a
// register holds up to four of the row's particles times as many of its own as fit, so that 16 pairs are computed in
// one to eight operations, without a branch and without indirection. Pairs outside the support add zero.
//
// Only for files that are compiled once per instruction set; they instantiate sum_block for each pass and number type.
#pragma once

#include "kernels/pairs/block_loop.hpp"
#include "kernels/pairs/pair.hpp"
#include "kernels/pairs/tile.hpp"

namespace sluice::SLUICE_ISA {
namespace detail {

template <class Pass>
constexpr Length length_of() {
    if constexpr (requires { Pass::length; })
        return Pass::length;
    else
        return Length::mean;
}

/// Sums of one register of i's own cluster over a row. OwnH: all its pairs have i's smoothing length.
template <bool OwnH, class Pass, class Real, class FourJ, class SideI>
SLUICE_INLINE void sum_row(const Pass& pass, const Smoothing<Pass::dim>& smoothing, const SideI& self,
                           const FourJ* tile, const std::uint8_t* entry, const std::uint8_t* end,
                           Vec<Pass::outputs, Real>& sum) {
    constexpr int dim = Pass::dim, along_j = Real::along_j;
    using SideJ = Side<dim, Real, Pass::reads_j>;
    const Real own_h = self.smoothing_length();
    const Real own_inverse_h = reciprocal(own_h), own_scale = smoothing.scale(own_inverse_h);
    const Real own_slope_scale = Real(smoothing.slope_scale) * own_scale * own_inverse_h;
    const Real smallest(std::numeric_limits<typename Real::Number>::min());
    for (; entry != end; ++entry)
        for (int half = 0; half < 4; half += along_j) {
            const FourJ& four = tile[*entry];
            SideJ other;
            unroll<SideJ::Slot::count>([&](int s) __attribute__((always_inline)) {
                other.value[s] = load_repeated<Real, along_j>(four.value[s] + half);
            });
            const Vec<dim, Real> x_ij = self.place() - other.place();
            Real r2 = smallest;
            unroll<dim>([&](int k) __attribute__((always_inline)) { r2 = r2 + x_ij[k] * x_ij[k]; });
            const Real other_h = other.smoothing_length();
            const Real mean_h = length_of<Pass>() == Length::of_j ? other_h : Real(0.5) * (own_h + other_h);
            const Real h = OwnH ? own_h : mean_h;
            const Real inverse_h = OwnH ? own_inverse_h : reciprocal(h);
            const Real scale = OwnH ? own_scale : smoothing.scale(inverse_h);
            const Real slope_scale = OwnH ? own_slope_scale : Real(smoothing.slope_scale) * scale * inverse_h;
            const Pair<dim, SideI, SideJ> pair{smoothing,        self, other,     x_ij,  r2,
                                               inverse_sqrt(r2), h,    inverse_h, scale, slope_scale};
            const Vec<Pass::outputs, Real> value = pass(pair);
            unroll<Pass::outputs>([&](int k) __attribute__((always_inline)) { sum[k] += value[k]; });
        }
}

}  // namespace detail

template <class Pass, class Number>
void sum_block(const BlockTask<Pass::dim>& task, const ListView::Block& block, const Pass& given, double* sums) {
    // Copies that nothing else can write to: their constants stay in registers.
    const Pass pass = given;
    const Smoothing<Pass::dim> smoothing = task.smoothing;
    constexpr int dim = Pass::dim, outputs = Pass::outputs;
    using Real = Pack<Number>;
    using FourI = Four<dim, Number, Pass::reads_i>;
    using FourJ = Four<dim, Number, Pass::reads_j>;
    constexpr int along_i = Real::along_i, along_j = Real::along_j;

    constexpr auto place = place_of<Pass>();
    const auto columns_i = FourI::Slot::of_view(task.a, place);
    const auto columns_j = FourJ::Slot::of_view(task.b, place);
    const ListView& list = task.list;
    const Index somewhere = list.query[block.queries.begin].particle(0, list.query_index);
    double origin_i[FourI::Slot::count] = {}, origin_j[FourJ::Slot::count] = {};
    for (int k = 0; k < dim; ++k) origin_i[k] = origin_j[k] = columns_i[static_cast<std::size_t>(k)][somewhere];

    const Index queries = block.queries.end - block.queries.begin;
    for (Index s = 0; s < queries * 4 * outputs; ++s) sums[s] = 0;
    FourJ tile[part_size];
    for (Index p = block.parts.begin; p < block.parts.end; ++p) {
        const ListView::Part& part = list.part[p];
        const ListedCluster* candidate = list.candidate + part.candidates.begin;
        for (Index c = 0; c < part.candidates.end - part.candidates.begin; ++c)
            tile[c].gather(candidate[c], list.candidate_index, columns_j, origin_j);
        for (Index q = 0; q < queries; ++q) {
            const ListView::Row& row = list.row[part.first_row + q];
            if (row.near == 0) continue;
            const std::uint8_t *entry = list.entry + row.begin, *end = entry + row.near;
            FourI own;
            own.gather(list.query[block.queries.begin + q], list.query_index, columns_i, origin_i);
            for (int g = 0; g < 4; g += along_i) {
                Side<dim, Real, Pass::reads_i> self;
                for (int s = 0; s < FourI::Slot::count; ++s)
                    self.value[s] = load_spread<Real, along_j>(own.value[s] + g);
                Vec<outputs, Real> sum;
                constexpr Length length = detail::length_of<Pass>();
                const bool equal = list.equal_reach[block.queries.begin + q] != 0;
                if (length == Length::of_i || (length == Length::mean && equal))
                    detail::sum_row<true>(pass, smoothing, self, tile, entry, end, sum);
                else
                    detail::sum_row<false>(pass, smoothing, self, tile, entry, end, sum);
                for (int k = 0; k < outputs; ++k)
                    add_block_sums<along_j>(sum[k], sums + (q * outputs + static_cast<Index>(k)) * 4 + g);
            }
        }
    }
}

#ifndef SLUICE_ISA_counted
/// For the files that compile loops: the loop of one pass for one number type.
#define SLUICE_INSTANTIATE_PASS(Number, ...)                                                                 \
    template void sum_block<__VA_ARGS__, Number>(const BlockTask<__VA_ARGS__::dim>&, const ListView::Block&, \
                                                 const __VA_ARGS__&, double*);
#endif

}  // namespace sluice::SLUICE_ISA

#ifdef SLUICE_ISA_counted
#include "kernels/pairs/operation_count.hpp"
#endif
