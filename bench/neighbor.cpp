// The search, stage by stage. Counter: particles per second.
#include <benchmark/benchmark.h>

#include <random>

#include "bench/lattice.hpp"
#include "neighbor/morton.hpp"
#include "neighbor/radix_sort.hpp"

namespace sluice::bench {
namespace {

void set_rate(benchmark::State& state, std::size_t items) {
    state.counters["particles/s"] =
        benchmark::Counter(static_cast<double>(items), benchmark::Counter::kIsIterationInvariantRate);
}

void morton_encode_2d(benchmark::State& state) {
    std::vector<std::array<std::uint32_t, 2>> cells(4096);
    std::mt19937 random(1);
    for (auto& c : cells) c = {static_cast<std::uint32_t>(random()), static_cast<std::uint32_t>(random())};
    for (auto _ : state)
        for (const auto& c : cells) benchmark::DoNotOptimize(morton_encode<2>(c));
    set_rate(state, cells.size());
}
BENCHMARK(morton_encode_2d);

void radix_sort(benchmark::State& state) {
    const auto n = static_cast<std::size_t>(state.range(0));
    Array<std::uint64_t> keys(n), work(n);
    Array<Index> values(n);
    std::mt19937 random(1);
    for (auto& k : keys) k = random() & 0xfffff;
    RadixSorter sorter;
    for (auto _ : state) {
        work = keys;
        sorter.sort(work, values, 20);
        benchmark::DoNotOptimize(work.data());
    }
    set_rate(state, n);
}
BENCHMARK(radix_sort)->Arg(6000)->Arg(100000)->Arg(1000000)->MeasureProcessCPUTime();

template <int Dim>
void cell_grid(benchmark::State& state) {
    Block<Dim> block(static_cast<std::size_t>(state.range(0)), 1.5);
    for (auto _ : state) block.grid.build(block.position, block.position.size(), 3.375e-3, block.h);
    set_rate(state, block.position.size());
}
BENCHMARK_TEMPLATE(cell_grid, 2)->Arg(6000)->Arg(100000)->MeasureProcessCPUTime();
BENCHMARK_TEMPLATE(cell_grid, 3)->Arg(6000)->Arg(100000)->MeasureProcessCPUTime();

/// Second argument: group size.
template <int Dim>
void neighbor_list(benchmark::State& state) {
    Block<Dim> block(static_cast<std::size_t>(state.range(0)), 1.5);
    for (auto _ : state) block.search(static_cast<int>(state.range(1)));
    set_rate(state, block.position.size());
}
BENCHMARK_TEMPLATE(neighbor_list, 2)->ArgsProduct({{6000, 100000}, {1, 8}})->MeasureProcessCPUTime();
BENCHMARK_TEMPLATE(neighbor_list, 3)->ArgsProduct({{6000, 100000}, {1, 8}})->MeasureProcessCPUTime();

}  // namespace
}  // namespace sluice::bench
