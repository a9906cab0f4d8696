// What one core of this machine can do at most, measured: arithmetic per instruction set and precision, and copying.
// Every pass is held against it (bench/README.md).
#pragma once

#include "kernels/pairs/block_loop.hpp"
#include "neighbor/isa.hpp"

namespace sluice::bench {

/// Bytes moved by a copy per second of CPU time, those read and those written.
struct CopyRate {
    double memory = 0;  ///< arrays far larger than the last-level cache [B/s]
    double l2 = 0;      ///< arrays that stay in the second-level cache [B/s]
};

/// Additions and multiplications per second, all lanes: multiply-adds on independent registers. Measured on first use.
double arithmetic_peak(Isa isa, Precision precision);

/// Measured on first use.
const CopyRate& copy_rate();

}  // namespace sluice::bench
