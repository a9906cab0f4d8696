// Whole steps of the validation scenes. Counter: particle-steps per second of process CPU time. Argument: threads.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "engine/simulation.hpp"

namespace sluice::bench {
namespace {

void step_of(benchmark::State& state, const char* scene) {
    omp_set_num_threads(static_cast<int>(state.range(0)));
    Simulation<2> simulation(load_scene(std::string(SLUICE_VALIDATION) + "/" + scene + "/scene.toml"));
    for (int s = 0; s < 20; ++s) simulation.step();
    const std::uint64_t before = simulation.work().particle_steps;
    for (auto _ : state) simulation.step();
    state.counters["particle-steps/s"] =
        benchmark::Counter(static_cast<double>(simulation.work().particle_steps - before), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(step_of, elastic_gate, "elastic_gate")->Arg(1)->Arg(2)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(step_of, oscillating_plate, "oscillating_plate")
    ->Arg(1)
    ->Arg(2)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace sluice::bench
