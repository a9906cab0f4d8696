// The plain twin of the neighbour search: every pair is looked at. For tests and as the definition of what is right.
#pragma once

#include <vector>

#include "neighbor/neighbor_list.hpp"

namespace sluice {

/// For each of the first `owned` queries, the ascending indices of the targets within the cut-off. If both sets have
/// the same position field, a particle is not its own neighbour.
template <int Dim>
std::vector<std::vector<Index>> all_pairs(const typename NeighborSearch<Dim>::Set& query, std::size_t owned,
                                          const typename NeighborSearch<Dim>::Set& target, const CutOff& cut) {
    const bool same_set = &query.position == &target.position;
    std::vector<std::vector<Index>> result(owned);
    for (std::size_t i = 0; i < owned; ++i)
        for (std::size_t j = 0; j < target.position.size(); ++j) {
            const double limit = cut.query_scale * query.reach[i] + cut.skin + cut.target_scale * target.reach[j];
            if (same_set && i == j) continue;
            if (norm2(query.position[i] - target.position[j]) < limit * limit)
                result[i].push_back(static_cast<Index>(j));
        }
    return result;
}

}  // namespace sluice
