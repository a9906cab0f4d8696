// Sums a pass's results over all particles, within blocks and then over blocks in order: the same bits for any number
// of threads.
#pragma once

#include <vector>

#include "neighbor/vec.hpp"

namespace sluice {

/// Scratch for passes that return a sum over all particles; kept by the caller, so that a step allocates nothing.
template <int Dim>
using BlockTotals = std::vector<Vec<Dim>>;

template <int Dim>
Vec<Dim> total_of(const BlockTotals<Dim>& totals) {
    Vec<Dim> sum;
    for (const Vec<Dim>& block : totals) sum += block;
    return sum;
}

}  // namespace sluice
