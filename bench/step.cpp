// Whole steps: of the validation scenes, and of a dam break per particle count. Rates are per second of process CPU
// time, that is per core; `by_the_clock` is what a user sees.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

#include "bench/counters.hpp"
#include "bench/dam_break.hpp"
#include "bench/suite.hpp"
#include "engine/simulation/simulation.hpp"

namespace sluice::bench {
namespace {

struct Case {
    std::string name;
    int dimension;
    std::function<Scene()> scene;
    int steps;  ///< the same in every run, from the same start: so is the work
};

/// Steps before the clock starts: the first lists are built, memory is touched.
constexpr int first_steps = 3;

double seconds_in(const PhaseTimer& timer, StepPhase phase) { return timer.seconds()[static_cast<std::size_t>(phase)]; }

template <int Dim>
void run_steps(benchmark::State& state, const Case& c, int threads) {
    omp_set_num_threads(threads);
    Simulation<Dim> simulation(c.scene());
    for (int s = 0; s < first_steps; ++s) simulation.step();
    const WorkCount before = simulation.work();
    const PhaseTimer timer_before = simulation.timer();
    const auto start = std::chrono::steady_clock::now();
    for (auto _ : state) simulation.step();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    const WorkCount after = simulation.work();
    const auto particle_steps = static_cast<double>(after.particle_steps - before.particle_steps);
    const auto pairs = static_cast<double>(after.pairs - before.pairs);
    const auto steps = static_cast<double>(after.steps - before.steps);
    const auto particles = static_cast<double>(simulation.fluid().owned + simulation.solid().owned);
    const auto share = [&](StepPhase phase) {
        return (seconds_in(simulation.timer(), phase) - seconds_in(timer_before, phase)) / elapsed.count();
    };
    state.counters["particle-steps/s"] = {particle_steps, benchmark::Counter::kIsRate};
    state.counters["by_the_clock"] = particle_steps / elapsed.count();
    state.counters["pairs/s"] = {pairs, benchmark::Counter::kIsRate};
    state.counters["bytes/particle"] = static_cast<double>(simulation.memory_bytes()) / particles;
    state.counters["builds/step"] = static_cast<double>(after.neighbour_builds - before.neighbour_builds) / steps;
    state.counters["search_share"] = share(StepPhase::search);
    state.counters["update_share"] = share(StepPhase::update);
}

/// Reading the scene is in the time, and so is all else up to the first step.
template <int Dim>
void run_start(benchmark::State& state, const Case& c, int threads) {
    omp_set_num_threads(threads);
    double particles = 0;
    for (auto _ : state) {
        const Simulation<Dim> simulation(c.scene());
        particles = static_cast<double>(simulation.fluid().owned + simulation.solid().owned);
    }
    state.counters["particles/s"] = per_second(particles);
}

void register_case(const Case& c, const std::string& folder, int threads) {
    const std::string arguments = c.name + "/threads:" + std::to_string(threads);
    benchmark::RegisterBenchmark((folder + "step/" + arguments).c_str(), c.dimension == 2 ? run_steps<2> : run_steps<3>,
                                 c, threads)
        ->Iterations(c.steps)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
    benchmark::RegisterBenchmark((folder + "start/" + arguments).c_str(),
                                 c.dimension == 2 ? run_start<2> : run_start<3>, c, threads)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
}

Case validation_case(const std::string& scene, const std::string& precision) {
    const std::string path = std::string(SLUICE_VALIDATION) + "/" + scene + "/scene.toml";
    return {scene + "/" + (precision == "mixed" ? "mixed" : "full"), 2,
            [=] { return load_scene(path, {"method.precision=" + precision}); }, 200};
}

Case dam_break_case(const DamBreak& dam) {
    const std::string name = "dam_break/dim:" + std::to_string(dam.dimension) +
                             "/h:" + std::to_string(static_cast<int>(100 * dam.h_over_d + 0.5)) +
                             "/n:" + std::to_string(dam.particles) + (dam.precision == "mixed" ? "/mixed" : "/full");
    // About two million particle-steps, a second, but enough steps for a few builds.
    const int steps = std::max(2'000'000 / dam.particles, 6);
    return {name, dam.dimension, [=] { return make_scene(dam); }, steps};
}

}  // namespace

void register_steps() {
    for (const char* precision : {"mixed", "double"})
        for (const int threads : {1, 2}) {
            register_case(validation_case("elastic_gate", precision), "", threads);
            register_case(validation_case("oscillating_plate", precision), "", threads);
            for (const int n : {10'000, 100'000, 1'000'000, 4'000'000})
                for (const int dimension : {2, 3})
                    register_case(dam_break_case({dimension, n, dimension == 2 ? 1.5 : 1.2, precision}),
                                  n > 100'000 ? "large/" : "", threads);
        }
}

}  // namespace sluice::bench
