// The loop that prunes a block's rows, once per instruction set.
#pragma once

#include <cstdint>

#include "neighbor/neighbor_list.hpp"

namespace sluice {

/// Columns that pruning reads.
template <int Dim>
struct PruneColumns {
    const double* position[Dim] = {};
    const double* reach = nullptr;
};

/// What pruning works on.
template <int Dim>
struct PruneTask {
    PruneColumns<Dim> query, target;
    CutOff cut;
    ListView list;
    ListView::Row* row = nullptr;           ///< `near` is set
    const std::uint8_t* listed = nullptr;   ///< entries as found
    std::uint8_t* near = nullptr;           ///< entries as left
};

#define SLUICE_DECLARE_PRUNE(level)                                                       \
    namespace level {                                                                     \
    /** Returns the pairs (a particle with itself too) closer than their reaches. */      \
    template <int Dim>                                                                    \
    std::uint64_t prune_block(const PruneTask<Dim>& task, const ListView::Block& block);  \
    }
SLUICE_DECLARE_PRUNE(baseline)
SLUICE_DECLARE_PRUNE(avx2)
SLUICE_DECLARE_PRUNE(avx512)
#undef SLUICE_DECLARE_PRUNE

}  // namespace sluice
