// The loop that measures arithmetic: once per instruction set.
#pragma once

#include <cstdint>

#include "neighbor/isa.hpp"

namespace sluice::bench {

/// x ← x·a + b on so many registers in turn: enough to cover the latency of a multiplication and an addition on two
/// pipes each, few enough to stay in the sixteen registers of AVX2.
inline constexpr int accumulators = 12;

}  // namespace sluice::bench

#define SLUICE_DECLARE_ROOFLINE(level)                                                                        \
    namespace sluice::level {                                                                                 \
    /** Multiplies and adds `rounds` times on all accumulators; returns the operations done, lane by lane. */ \
    template <class Number>                                                                                   \
    std::uint64_t multiply_add(std::uint64_t rounds);                                                         \
    }
SLUICE_DECLARE_ROOFLINE(baseline)
SLUICE_DECLARE_ROOFLINE(avx2)
SLUICE_DECLARE_ROOFLINE(avx512)
#undef SLUICE_DECLARE_ROOFLINE
