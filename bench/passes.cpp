// Each pair pass on a block of particles. Counter: directed pairs inside the support per second, of process CPU time.
// Arguments: particles, h/d in hundredths, group size.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "bench/lattice.hpp"
#include "kernels/fluid_passes.hpp"
#include "kernels/solid_passes.hpp"

namespace sluice::bench {
namespace {

template <int Dim, class Pass>
void run_pass(benchmark::State& state, Pass&& pass) {
    omp_set_num_threads(1);
    Block<Dim> block(static_cast<std::size_t>(state.range(0)), 0.01 * static_cast<double>(state.range(1)),
                     static_cast<int>(state.range(2)));
    VectorField<Dim> vectors;
    vectors.resize(block.position.size());
    ScalarField scalars(block.position.size());
    TupleField<Dim * Dim> tensors;
    tensors.resize(block.position.size());
    for (auto _ : state) {
        pass(block, vectors, scalars, tensors);
        benchmark::ClobberMemory();
    }
    state.counters["pairs/s"] =
        benchmark::Counter(static_cast<double>(block.list.pairs()), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["pairs/particle"] =
        static_cast<double>(block.list.pairs()) / static_cast<double>(block.position.size());
    state.counters["candidates/pair"] = [&] {
        double lanes = 0;
        for (std::size_t g = 0; g < block.list.groups(); ++g)
            lanes += static_cast<double>(block.list.candidates(g).size() * block.list.queries(g).size());
        return lanes / static_cast<double>(block.list.pairs());
    }();
}

template <int Dim, class Real>
void fluid_momentum_pass(benchmark::State& state) {
    run_pass<Dim>(state, [](auto& b, auto& v, auto&, auto&) { fluid_momentum<Dim, Real>(b.view(), b.list, {}, v); });
}
template <int Dim, class Real>
void continuity_pass(benchmark::State& state) {
    run_pass<Dim>(state, [](auto& b, auto&, auto& s, auto&) { continuity<Dim, Real>(b.view(), b.list, s); });
}
template <int Dim, class Real>
void velocity_filter_pass(benchmark::State& state) {
    run_pass<Dim>(state, [](auto& b, auto& v, auto&, auto&) { velocity_filter<Dim, Real>(b.view(), b.list, 0.92, v); });
}
template <int Dim, class Real>
void solid_momentum_pass(benchmark::State& state) {
    run_pass<Dim>(state, [](auto& b, auto& v, auto&, auto&) {
        solid_momentum<Dim, Real>(b.view(), b.list, {1.0, 134.8, 0.3, 4, 1.5}, v);
    });
}
template <int Dim, class Real>
void solid_rates_pass(benchmark::State& state) {
    run_pass<Dim>(state, [](auto& b, auto&, auto& s, auto& t) { solid_rates<Dim, Real>(b.view(), b.list, s, t); });
}

#define SLUICE_PASS(pass)                                                                                       \
    BENCHMARK_TEMPLATE(pass, 2, double)->ArgsProduct({{6000, 100000}, {150}, {4, 8}})->MeasureProcessCPUTime(); \
    BENCHMARK_TEMPLATE(pass, 2, float)->ArgsProduct({{6000, 100000}, {150}, {8}})->MeasureProcessCPUTime();     \
    BENCHMARK_TEMPLATE(pass, 3, double)->ArgsProduct({{100000}, {120, 150}, {8}})->MeasureProcessCPUTime();     \
    BENCHMARK_TEMPLATE(pass, 3, float)->ArgsProduct({{100000}, {120, 150}, {8}})->MeasureProcessCPUTime();
SLUICE_PASS(fluid_momentum_pass)
SLUICE_PASS(continuity_pass)
SLUICE_PASS(velocity_filter_pass)
SLUICE_PASS(solid_momentum_pass)
SLUICE_PASS(solid_rates_pass)
#undef SLUICE_PASS

}  // namespace
}  // namespace sluice::bench
