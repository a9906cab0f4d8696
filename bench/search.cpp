// The search, stage by stage: keys, sort, cells, clusters, lists, pruning. Rates are per second of process CPU time.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <random>
#include <string>

#include "bench/counters.hpp"
#include "bench/lattice.hpp"
#include "bench/suite.hpp"
#include "neighbor/isa.hpp"
#include "neighbor/morton.hpp"
#include "neighbor/radix_sort.hpp"

namespace sluice::bench {
namespace {

struct Arguments {
    std::size_t particles;
    int threads;
    int h_over_d = 150;  ///< in hundredths
    Isa isa = available_isas().back();
};

void count(benchmark::State& state, std::size_t particles, std::size_t bytes) {
    const auto n = static_cast<double>(particles);
    state.counters["particles/s"] = per_second(n);
    if (bytes > 0) state.counters["bytes/particle"] = static_cast<double>(bytes) / n;
}

template <int Dim>
void encode(benchmark::State& state) {
    Array<std::array<std::uint32_t, Dim>> cells(4096);
    Array<std::uint64_t> keys(cells.size());
    std::mt19937 random(1);
    for (auto& cell : cells)
        for (auto& c : cell) c = static_cast<std::uint32_t>(random()) >> (32 - morton_bits<Dim>);
    for (auto _ : state) {
        for (std::size_t i = 0; i < cells.size(); ++i) keys[i] = morton_encode<Dim>(cells[i]);
        benchmark::DoNotOptimize(keys.data());
        benchmark::ClobberMemory();
    }
    count(state, cells.size(), 0);
}

/// Random keys of as many bits as the cells of so many particles have. The copy of the unsorted keys is in the time.
void sort(benchmark::State& state, const Arguments& a) {
    omp_set_num_threads(a.threads);
    const std::size_t n = a.particles;
    int bits = 1;
    while ((n / (block_size * cluster_size)) >> bits != 0) ++bits;
    Array<std::uint64_t> given(n), keys(n);
    Array<Index> values(n);
    std::mt19937_64 random(1);
    for (auto& key : given) key = random() >> (64 - bits);
    for (auto _ : state) {
        keys = given;
        radix_sort(keys, values, bits);
        benchmark::ClobberMemory();
    }
    state.counters["key_bits"] = bits;
    count(state, n, 0);
}

/// Places a little off those that the particles were sorted by: half of the skin on average, when an engine builds
/// anew.
template <int Dim>
VectorField<Dim> moved(const Medium<Dim>& medium) {
    VectorField<Dim> places = medium.position;
    std::mt19937 random(3);
    const double farthest = 0.5 * build_skin * medium.h[0];
    std::uniform_real_distribution<double> shift(-farthest, farthest);
    for (ScalarField& column : places.c)
        for (double& x : column) x += shift(random);
    return places;
}

template <int Dim>
Cube<Dim>& cube_of(const Arguments& a) {
    return cached<Cube<Dim>>(a.particles, 0.01 * a.h_over_d);
}

template <int Dim, template <int> class Grid>
void build_grid(benchmark::State& state, const Arguments& a) {
    const Medium<Dim>& medium = cube_of<Dim>(a).medium;
    const VectorField<Dim> places = moved(medium);
    omp_set_num_threads(a.threads);
    Grid<Dim> grid;
    for (auto _ : state) grid.build(places, 0, places.size(), cell_size<Dim>, medium.h);
    count(state, places.size(), grid.bytes());
}

/// Cluster pairs that were found, not only those that pruning has left.
std::uint64_t listed(const NeighborList& list) {
    std::uint64_t sum = 0;
    const ListView view = list.view();
    for (std::size_t b = 0; b < list.blocks(); ++b)
        for (Index p = view.block[b].parts.begin; p < view.block[b].parts.end; ++p)
            for (Index q = 0; q < view.block[b].queries.size(); ++q) sum += view.row[view.part[p].first_row + q].listed;
    return sum;
}

template <int Dim>
void count(benchmark::State& state, const Cube<Dim>& cube, std::size_t bytes) {
    const auto clusters = static_cast<double>(listed(cube.list));
    state.counters["cluster_pairs/s"] = per_second(clusters);
    state.counters["pairs/s"] = per_second(static_cast<double>(cube.list.pairs()));
    count(state, cube.medium.size(), bytes);
}

template <int Dim>
void build_list(benchmark::State& state, const Arguments& a) {
    const Cube<Dim>& cube = cube_of<Dim>(a);
    const Medium<Dim>& medium = cube.medium;
    omp_set_num_threads(a.threads);
    use_isa(name_of(a.isa));
    NeighborSearch<Dim> search;
    NeighborList list;
    const ClusterGrid<Dim>* const target = &medium.grid;
    for (auto _ : state) search.build(medium.grid, {&target, 1}, {build_skin * medium.h[0]}, list);
    count(state, cube, list.bytes());
}

/// After a build: pairs are counted too.
template <int Dim>
void prune_first(benchmark::State& state, const Arguments& a) {
    const Cube<Dim>& cube = cube_of<Dim>(a);
    const Medium<Dim>& medium = cube.medium;
    omp_set_num_threads(a.threads);
    use_isa(name_of(a.isa));
    NeighborSearch<Dim> search;
    NeighborList built, list;
    const ClusterGrid<Dim>* const target = &medium.grid;
    search.build(medium.grid, {&target, 1}, {build_skin * medium.h[0]}, built);
    for (auto _ : state) {
        state.PauseTiming();
        list = built;
        state.ResumeTiming();
        search.prune(medium.set(), medium.set(), {pruned_skin * medium.h[0]}, list);
    }
    count(state, cube, list.bytes());
}

template <int Dim>
void prune_again(benchmark::State& state, const Arguments& a) {
    Cube<Dim>& cube = cube_of<Dim>(a);
    const Medium<Dim>& medium = cube.medium;
    omp_set_num_threads(a.threads);
    use_isa(name_of(a.isa));
    NeighborSearch<Dim> search;
    for (auto _ : state) search.prune(medium.set(), medium.set(), {pruned_skin * medium.h[0]}, cube.list);
    count(state, cube, cube.list.bytes());
}

using Function = void (*)(benchmark::State&, const Arguments&);

void register_one(const std::string& name, Function function, const Arguments& a) {
    const std::string full = "search/" + name + "/threads:" + std::to_string(a.threads);
    benchmark::RegisterBenchmark(full.c_str(), function, a)->MeasureProcessCPUTime();
}

template <int Dim>
void register_lists(const Arguments& a) {
    const std::string arguments = "/dim:" + std::to_string(Dim) + "/h:" + std::to_string(a.h_over_d) +
                                  "/n:" + std::to_string(a.particles) + "/" + std::string(name_of(a.isa));
    register_one("list" + arguments, build_list<Dim>, a);
    register_one("prune_first" + arguments, prune_first<Dim>, a);
    register_one("prune_again" + arguments, prune_again<Dim>, a);
}

template <int Dim>
void register_sizes(std::size_t particles, int threads) {
    const std::string arguments = "/dim:" + std::to_string(Dim) + "/n:" + std::to_string(particles);
    // Cells know no smoothing length.
    register_one("cell_grid" + arguments, build_grid<Dim, CellGrid>, {particles, threads, 120});
    register_one("cluster_grid" + arguments, build_grid<Dim, ClusterGrid>, {particles, threads, 120});
    for (const int h : {120, 150})
        for (const Isa isa : available_isas())
            if (isa == available_isas().back() || (threads == 1 && particles <= 100'000))
                register_lists<Dim>({particles, threads, h, isa});
}

}  // namespace

void register_search() {
    benchmark::RegisterBenchmark("search/morton_encode/dim:2", encode<2>)->MeasureProcessCPUTime();
    benchmark::RegisterBenchmark("search/morton_encode/dim:3", encode<3>)->MeasureProcessCPUTime();
    for (const std::size_t n : {10'000U, 100'000U, 1'000'000U})
        for (const int threads : {1, 2}) {
            if (threads > 1 && n != 100'000) continue;
            register_one("radix_sort/n:" + std::to_string(n), sort, {n, threads});
            register_sizes<2>(n, threads);
            register_sizes<3>(n, threads);
        }
}

}  // namespace sluice::bench
