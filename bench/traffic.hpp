// Bytes of columns that a pass cannot avoid to read and write, if each is moved once: what it would move through a
// cache that keeps everything until the pass is over.
#pragma once

#include <cstddef>

#include "kernels/pairs/particle_view.hpp"

namespace sluice::bench {

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
