// Pressure from density, particle by particle: linear, Tait's with γ = 7, and with any other exponent.
#include <benchmark/benchmark.h>

#include <random>
#include <string>

#include "bench/counters.hpp"
#include "bench/suite.hpp"
#include "kernels/materials/equation_of_state.hpp"
#include "neighbor/fields.hpp"

namespace sluice::bench {
namespace {

/// In the first-level cache.
constexpr std::size_t particles = 1024;

void run_pressure(benchmark::State& state, double exponent) {
    EquationOfState given{1000, 30, exponent};
    ScalarField density(particles), pressure(particles);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> weakly_compressed(990, 1010);
    for (double& rho : density) rho = weakly_compressed(random);
    for (auto _ : state) {
        benchmark::DoNotOptimize(given);  // the exponent is not known when this is compiled
        const EquationOfState eos = given;
        for (std::size_t i = 0; i < particles; ++i) pressure[i] = eos.pressure(density[i]);
        benchmark::ClobberMemory();
    }
    state.counters["evaluations/s"] = per_second(static_cast<double>(particles));
}

}  // namespace

void register_equations_of_state() {
    for (const double exponent : {1.0, 7.0, 7.15}) {
        const std::string name = exponent == 1 ? "linear" : exponent == 7 ? "tait" : "tait_any_exponent";
        benchmark::RegisterBenchmark(("equation_of_state/" + name).c_str(), run_pressure, exponent)
            ->MeasureProcessCPUTime();
    }
}

}  // namespace sluice::bench
