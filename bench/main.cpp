#include <benchmark/benchmark.h>

#include "bench/suite.hpp"

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    sluice::bench::register_roofline();
    sluice::bench::register_search();
    sluice::bench::register_smoothing();
    sluice::bench::register_passes();
    sluice::bench::register_equations_of_state();
    sluice::bench::register_steps();
    const std::size_t run = benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return run > 0 ? 0 : 1;
}
