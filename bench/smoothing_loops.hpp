// The loops that evaluate smoothing functions: once per instruction set.
#pragma once

#include <cstddef>

#include "kernels/pairs/block_loop.hpp"
#include "neighbor/isa.hpp"

namespace sluice::bench {

/// Numbers that a loop goes over: they stay in the first-level cache.
inline constexpr std::size_t smoothing_arguments = 1024;

/// One function evaluated in one precision.
struct SmoothingLoop {
    const char* function;
    const char* quantity;  ///< shape or reduced_slope
    Precision precision;
    /// Evaluates at all q (floats or doubles, by precision) and stores the values.
    void (*run)(const void* q, void* values);
};

/// All of them. A plain table: what the newer instruction sets compile of the standard library could end up elsewhere.
struct SmoothingLoops {
    const SmoothingLoop *first, *last;
    const SmoothingLoop* begin() const { return first; }
    const SmoothingLoop* end() const { return last; }
};

}  // namespace sluice::bench

#define SLUICE_DECLARE_SMOOTHING(level)      \
    namespace sluice::level {                \
    bench::SmoothingLoops smoothing_loops(); \
    }
SLUICE_DECLARE_SMOOTHING(baseline)
SLUICE_DECLARE_SMOOTHING(avx2)
SLUICE_DECLARE_SMOOTHING(avx512)
#undef SLUICE_DECLARE_SMOOTHING
