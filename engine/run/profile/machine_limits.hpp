// What this machine can do at most, measured: arithmetic, and moving numbers between a core and each of its memories.
#pragma once

#include <array>
#include <cstddef>

#include "neighbor/isa.hpp"

namespace sluice {

/// Per second of the clock.
struct Limit {
    double one_thread = 0, all_threads = 0;
};

/// A cache, or the main memory behind the last of them.
struct MemoryLevel {
    const char* name = "";
    std::size_t bytes = 0;  ///< that it holds: a core's own, or all cores' together; 0 = no bound
    bool shared = true;     ///< by all cores
    Limit bandwidth;        ///< of triad [B/s]
};

/// [McCalpin1995] "Memory bandwidth and machine balance in current high performance computers": triad, a = b + s c, of
/// which two numbers read and one written are counted, though most processors read what they write over, too.
/// [Williams2009] "Roofline: an insightful visual performance model": what a loop can reach at most is the smaller of
/// the arithmetic peak, and of the bandwidth times the operations that it does for each byte.
struct MachineLimits {
    Isa isa = Isa::baseline;  ///< the arithmetic's
    int threads = 1;
    Limit single_precision, double_precision;  ///< multiplications and additions, fused where the level can [1/s]
    std::array<MemoryLevel, 3> memory;         ///< second-level cache, last-level cache, main memory

    const Limit& arithmetic(std::size_t number_bytes) const {
        return number_bytes == sizeof(float) ? single_precision : double_precision;
    }
    /// Where so many bytes are found that all threads go through again and again.
    const MemoryLevel& level_of(double bytes, int on_threads) const;
};

/// For the instruction set in use, in about a second. The fastest of several tries counts, as whatever disturbs one
/// makes it slower.
MachineLimits measure_machine(int threads);

}  // namespace sluice
