// The loops that measure what a machine can do at most: once per instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "neighbor/isa.hpp"

namespace sluice {

/// x ← x·a + b on so many registers in turn: enough to cover the latency of a multiplication and an addition on two
/// pipes each, few enough to stay in the sixteen registers of AVX2.
inline constexpr int accumulators = 12;

}  // namespace sluice

#define SLUICE_DECLARE_ROOFLINE(level)                                                                        \
    namespace sluice::level {                                                                                 \
    /** Multiplies and adds `rounds` times on all accumulators; returns the operations done, lane by lane. */ \
    template <class Number>                                                                                   \
    std::uint64_t multiply_add(std::uint64_t rounds);                                                         \
    /** a = b + s c, n numbers each [McCalpin1995]; returns the bytes read and written, 24 for each. */       \
    std::uint64_t triad(double* a, const double* b, const double* c, std::size_t n);                          \
    }
SLUICE_DECLARE_ROOFLINE(baseline)
SLUICE_DECLARE_ROOFLINE(avx2)
SLUICE_DECLARE_ROOFLINE(avx512)
#undef SLUICE_DECLARE_ROOFLINE
