// Sums over all particles of what a pass computes, block by block and then in the blocks' order: the same bits for any
// number of threads.
#pragma once

#include <vector>

#include "neighbor/vec.hpp"

namespace sluice {

/// Scratch of the passes that return a sum over all particles; kept by the caller, so that nothing is allocated.
template <int Dim>
using BlockTotals = std::vector<Vec<Dim>>;

template <int Dim>
Vec<Dim> total_of(const BlockTotals<Dim>& totals) {
    Vec<Dim> sum;
    for (const Vec<Dim>& block : totals) sum += block;
    return sum;
}

}  // namespace sluice
