#include <benchmark/benchmark.h>

#include "bench/suite.hpp"

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    sluice::bench::register_roofline();
#ifndef BENCH_DEV
    sluice::bench::register_steps();
#endif
    sluice::bench::register_passes();
    const std::size_t run = benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return run > 0 ? 0 : 1;
}
