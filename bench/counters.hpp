// What benchmarks report.
#pragma once

#include <benchmark/benchmark.h>

namespace sluice::bench {

/// Work per iteration, as a rate; as a fraction of a limit if the work is divided by what the limit allows per second.
inline benchmark::Counter per_second(double work) { return {work, benchmark::Counter::kIsIterationInvariantRate}; }

}  // namespace sluice::bench
