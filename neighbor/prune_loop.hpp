// The loops of the search, once per instruction set: candidates of a cluster by boxes, and pruning by distances.
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
    bool count = false;  ///< pairs within their reaches, in double; else single precision will do
    ListView list;
    ListView::Row* row = nullptr;          ///< `near` is set
    const std::uint8_t* listed = nullptr;  ///< entries as found
    std::uint8_t* near = nullptr;          ///< entries as left
};

#define SLUICE_DECLARE_PRUNE(level)                                                                                         \
    namespace level {                                                                                                       \
    /** Returns the pairs (a particle with itself too) closer than their reaches, if they are counted. */                   \
    template <int Dim>                                                                                                      \
    std::uint64_t prune_block(const PruneTask<Dim>& task, const ListView::Block& block);                                    \
    /** Writes the numbers 0 … count − 1 of those boxes first … first + count − 1 that are closer to `own` than the \
        cut-off. */                                                                                                         \
    template <int Dim>                                                                                                      \
    NearBoxes find_near(const BoxColumns<Dim>& boxes, std::size_t first, std::size_t count, const Extent<Dim>& own,         \
                        const CutOff& cut, std::uint8_t* out);                                                              \
    }
SLUICE_DECLARE_PRUNE(baseline)
SLUICE_DECLARE_PRUNE(avx2)
SLUICE_DECLARE_PRUNE(avx512)
#undef SLUICE_DECLARE_PRUNE

}  // namespace sluice
