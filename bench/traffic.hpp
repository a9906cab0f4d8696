// Bytes that a pass cannot avoid to read and write, if each is moved once: what it would move through a cache that
// keeps everything until the pass is over.
#pragma once

#include <cstddef>

#include "kernels/columns.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice::bench {

/// What a loop reads of a list.
inline double list_bytes(const NeighborList& list) {
    const ListView view = list.view();
    std::size_t parts = 0, queries = 0, candidates = 0, rows = 0;
    for (std::size_t b = 0; b < list.blocks(); ++b) {
        const ListView::Block& block = view.block[b];
        parts += block.parts.size();
        queries += block.queries.size();
        rows += std::size_t{block.parts.size()} * block.queries.size();
        for (Index p = block.parts.begin; p < block.parts.end; ++p) candidates += view.part[p].candidates.size();
    }
    return static_cast<double>(list.blocks() * sizeof(ListView::Block) + parts * sizeof(ListView::Part) +
                               queries * (sizeof(ListedCluster) + sizeof(*view.equal_reach)) +
                               candidates * sizeof(ListedCluster) + rows * sizeof(ListView::Row) +
                               list.cluster_pairs() * sizeof(*view.entry));
}

/// Columns that a pass reads of its queries and of its candidates, of both together, and that it adds to.
struct ColumnCounts {
    int of_queries = 0, of_candidates = 0, of_both = 0, written = 0;
};

template <class Pass>
ColumnCounts columns_of_pass(int written) {
    return {Slots<Pass::dim, Pass::reads_i>::count, Slots<Pass::dim, Pass::reads_j>::count,
            Slots<Pass::dim, Pass::reads_i | Pass::reads_j>::count, written};
}

/// What a loop reads and writes of columns; `candidates` is 0 if they are the queries.
inline double column_bytes(const ColumnCounts& columns, std::size_t queries, std::size_t candidates) {
    const auto q = static_cast<double>(queries), c = static_cast<double>(candidates);
    const double read = candidates == 0 ? columns.of_both * q : columns.of_queries * q + columns.of_candidates * c;
    return sizeof(double) * (read + 2 * columns.written * q);
}

}  // namespace sluice::bench
