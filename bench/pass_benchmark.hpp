// A pair pass as a benchmark: its name, what it runs on and what it costs.
#pragma once

#include <omp.h>

#include <string>
#include <vector>

#include "bench/counters.hpp"
#include "bench/lattice.hpp"
#include "bench/roofline.hpp"
#include "bench/traffic.hpp"
#include "kernels/passes/interface_passes.hpp"
#include "kernels/passes/shift_passes.hpp"

namespace sluice::bench {

/// What passes add to.
template <int Dim>
struct Output {
    VectorField<Dim> vectors;
    ScalarField scalars;
    TupleField<Dim * Dim> tensors, more_tensors;
    SymTensorField<Dim> symmetric;
    BlockTotals<Dim> totals;
    Columns<Dim> shift;

    explicit Output(std::size_t n) : scalars(n) {
        vectors.resize(n);
        tensors.resize(n);
        clear_surroundings<Dim>(shift, n, n);
        more_tensors.resize(n);
        symmetric.resize(n);
    }
};

/// Which particles of a sample a pass sums for, over which, by which list.
template <class Sample>
struct Roles {
    Medium<Sample::dim> Sample::*queries;
    Medium<Sample::dim> Sample::*candidates;
    NeighborList Sample::*list;
};

/// One pass on a Cube or a Boundary.
template <class Sample>
struct PassRow {
    using Run = void (*)(const Sample&, Precision, Output<Sample::dim>&);

    std::string name;
    Roles<Sample> roles;
    Run run;
    double (*operations)();  ///< per lane
    ColumnCounts columns;
};

/// `pass` is what is counted: the set of terms that `run` sums. `written`: the columns that it adds to.
template <class Pass, class Sample>
PassRow<Sample> pass_row(const std::string& name, const Roles<Sample>& roles, int written,
                         typename PassRow<Sample>::Run run) {
    return {name, roles, run, counted::operations_per_lane<Pass>, columns_of_pass<Pass>(written)};
}

struct PassArguments {
    int h_over_d;  ///< in hundredths
    std::size_t particles;
    Precision precision;
    Isa isa;
    int threads;

    std::string text(int dim) const {
        return "/dim:" + std::to_string(dim) + "/h:" + std::to_string(h_over_d) + "/n:" + std::to_string(particles) +
               (precision == Precision::mixed ? "/mixed/" : "/full/") + std::string(name_of(isa)) +
               "/threads:" + std::to_string(threads);
    }
};

template <class Sample>
void count_pass(benchmark::State& state, const PassRow<Sample>& pass, const PassArguments& a, const Sample& sample) {
    const NeighborList& list = sample.*pass.roles.list;
    const auto pairs = static_cast<double>(list.pairs()), particles = static_cast<double>(list.size());
    const double lanes = 16 * static_cast<double>(list.cluster_pairs());
    const bool one_set = pass.roles.queries == pass.roles.candidates;
    const std::size_t others = one_set ? 0 : (sample.*pass.roles.candidates).size();
    const double of_list = static_cast<double>(list.loop_bytes()),
                 of_columns = column_bytes(pass.columns, list.size(), others);
    state.counters["pairs/s"] = per_second(pairs);
    state.counters["of_fma_peak"] = per_second(pass.operations() * lanes / arithmetic_peak(a.isa, a.precision));
    state.counters["of_copy"] = per_second((of_list + of_columns) / copy_rate().memory);
    state.counters["pairs/particle"] = pairs / particles;
    state.counters["lanes/pair"] = lanes / pairs;
    state.counters["operations/lane"] = pass.operations();
    state.counters["list_bytes/particle"] = of_list / particles;
    state.counters["column_bytes/particle"] = of_columns / particles;
}

template <class Sample>
void run_pass(benchmark::State& state, const PassRow<Sample>& pass, const PassArguments& a) {
    omp_set_num_threads(a.threads);
    use_isa(name_of(a.isa));
    const Sample& sample = cached<Sample>(a.particles, 0.01 * a.h_over_d);
    Output<Sample::dim> output((sample.*pass.roles.queries).size());
    for (auto _ : state) {
        pass.run(sample, a.precision, output);
        benchmark::ClobberMemory();
    }
    count_pass(state, pass, a, sample);
}

template <class Sample>
void register_pass(const PassRow<Sample>& pass, const PassArguments& a, const std::string& folder = "") {
    const std::string name = folder + pass.name + a.text(Sample::dim);
    benchmark::RegisterBenchmark(name.c_str(), run_pass<Sample>, pass, a)->MeasureProcessCPUTime();
}

}  // namespace sluice::bench
