// The plain twin of the neighbour search: every pair is looked at. For tests and as the definition of what is right.
#pragma once

#include <algorithm>
#include <vector>

#include "neighbor/neighbor_list.hpp"

namespace sluice {

/// For each of the first `owned` query positions, the ascending indices of the targets within the cut-off.
template <int Dim>
std::vector<std::vector<Index>> all_pairs(const VectorField<Dim>& query, std::size_t owned,
                                          const VectorField<Dim>& target, const PairReach& reach) {
    std::vector<std::vector<Index>> result(owned);
    for (std::size_t i = 0; i < owned; ++i)
        for (std::size_t j = 0; j < target.size(); ++j) {
            const double cut = reach.skin + reach.of_query(i) + reach.of_target(j);
            const bool itself = &query == &target && i == j;
            if (!itself && norm2(query[i] - target[j]) < cut * cut) result[i].push_back(static_cast<Index>(j));
        }
    return result;
}

}  // namespace sluice
