// What the smoothing functions cost where nothing else does: evaluations per second of arguments in the first-level
// cache.
#include <benchmark/benchmark.h>

#include <map>
#include <random>

#include "bench/counters.hpp"
#include "bench/operations.hpp"
#include "bench/roofline.hpp"
#include "bench/smoothing_functions.hpp"
#include "bench/smoothing_loops.hpp"
#include "bench/suite.hpp"

namespace sluice::bench {
namespace {

SmoothingLoops loops_of(Isa isa) { return SLUICE_OF_ISA(isa, smoothing_loops)(); }

/// function/quantity
std::string name_of(const SmoothingLoop& loop) { return std::string(loop.function) + "/" + loop.quantity; }

/// Operations per evaluation, by the loop's name.
std::map<std::string, double> count_operations() {
    std::map<std::string, double> operations;
#define SLUICE_COUNT(name, ...)                                                              \
    operations[name "/shape"] = operations_of([](auto q) { return __VA_ARGS__::shape(q); }); \
    operations[name "/reduced_slope"] = operations_of([](auto q) { return __VA_ARGS__::reduced_slope(q); });
    SLUICE_SMOOTHING_FUNCTIONS(SLUICE_COUNT)
#undef SLUICE_COUNT
    return operations;
}

template <class Number>
void evaluate(benchmark::State& state, const SmoothingLoop& loop) {
    Array<Number> q(smoothing_arguments), values(smoothing_arguments);
    std::mt19937 random(1);
    std::uniform_real_distribution<Number> inside_and_beyond(0, Number(2.5));
    for (Number& x : q) x = inside_and_beyond(random);
    for (auto _ : state) {
        loop.run(q.data(), values.data());
        benchmark::ClobberMemory();
    }
}

void run_smoothing(benchmark::State& state, const SmoothingLoop& loop, Isa isa, double operations) {
    if (loop.precision == Precision::mixed)
        evaluate<float>(state, loop);
    else
        evaluate<double>(state, loop);
    const auto evaluations = static_cast<double>(smoothing_arguments);
    state.counters["evaluations/s"] = per_second(evaluations);
    state.counters["operations/lane"] = operations;
    state.counters["of_fma_peak"] = per_second(operations * evaluations / arithmetic_peak(isa, loop.precision));
}

}  // namespace

void register_smoothing() {
    const std::map<std::string, double> operations = count_operations();
    for (const Isa isa : available_isas())
        for (const SmoothingLoop& loop : loops_of(isa)) {
            const std::string name = "smoothing/" + name_of(loop) +
                                     (loop.precision == Precision::mixed ? "/mixed/" : "/full/") +
                                     std::string(sluice::name_of(isa));
            benchmark::RegisterBenchmark(name.c_str(), run_smoothing, loop, isa, operations.at(name_of(loop)))
                ->MeasureProcessCPUTime();
        }
}

}  // namespace sluice::bench
