// Each pair pass on a set of particles, per dimension, h/d in hundredths, particles, precision and instruction set. Rates
// are per second of process CPU time, so with two threads they are per core.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <memory>
#include <string>
#include <vector>

#include "bench/lattice.hpp"
#include "bench/operations.hpp"
#include "bench/roofline.hpp"
#include "bench/suite.hpp"
#include "bench/traffic.hpp"
#include "kernels/fluid_loops.hpp"
#include "kernels/fluid_passes.hpp"
#include "kernels/interface_loops.hpp"
#include "kernels/interface_passes.hpp"
#include "kernels/solid_loops.hpp"
#include "kernels/solid_passes.hpp"
#include "kernels/wall_loops.hpp"
#include "kernels/wall_passes.hpp"

namespace sluice::bench {
namespace {

constexpr FluidTerms fluid_terms{1, 30};
constexpr SolidTerms solid_terms{1, 134.8, 0.3, 4, 1.5};
constexpr double filter_theta = 0.92;

/// What passes add to.
template <int Dim>
struct Output {
    VectorField<Dim> vectors;
    ScalarField scalars;
    TupleField<Dim * Dim> tensors;
    BlockTotals<Dim> totals;

    explicit Output(std::size_t n) : scalars(n) {
        vectors.resize(n);
        tensors.resize(n);
    }
};

/// One pass on a Cube or a Boundary.
template <class Sample>
struct PassRow {
    static constexpr int dim = Sample::dim;
    std::string name;
    void (*run)(const Sample&, Precision, Output<dim>&);
    Medium<dim> Sample::*queries;
    Medium<dim> Sample::*candidates;
    NeighborList Sample::*list;
    double operations;  ///< per lane
    ColumnCounts columns;
};

template <int Dim>
std::vector<PassRow<Cube<Dim>>> cube_passes() {
    using Sample = Cube<Dim>;
    using Out = Output<Dim>;
    using StressTerms = StressDivergence<Dim, ArtificialViscosity, ArtificialStress>;
    const auto row = [](const char* name, auto pass, int written, auto run) {
        return PassRow<Sample>{
            name, run, &Sample::medium, &Sample::medium, &Sample::list, operations_per_lane(pass),
            columns_of_pass<decltype(pass)>(written)};
    };
    return {row("fluid_rates", FluidRates<Dim>{}, Dim + 1,
                [](const Sample& s, Precision p, Out& out) {
                    fluid_rates<Dim>(s.medium.view(), s.list, fluid_terms, p, out.vectors, out.scalars);
                }),
            row("fluid_momentum", ViscousMomentum<Dim>{}, Dim,
                [](const Sample& s, Precision p, Out& out) {
                    fluid_momentum<Dim>(s.medium.view(), s.list, fluid_terms, p, out.vectors);
                }),
            row("fluid_momentum_inviscid", InviscidMomentum<Dim>{}, Dim,
                [](const Sample& s, Precision p, Out& out) {
                    fluid_momentum<Dim>(s.medium.view(), s.list, {}, p, out.vectors);
                }),
            row("continuity", DensityRate<Dim>{}, 1,
                [](const Sample& s, Precision p, Out& out) {
                    continuity<Dim>(s.medium.view(), s.list, p, out.scalars);
                }),
            row("velocity_filter", FilterSums<Dim>{}, Dim,
                [](const Sample& s, Precision p, Out& out) {
                    velocity_filter<Dim>(s.medium.view(), s.list, filter_theta, p, out.vectors);
                }),
            row("solid_momentum", StressTerms{}, Dim,
                [](const Sample& s, Precision p, Out& out) {
                    solid_momentum<Dim>(s.medium.view(), s.list, solid_terms, p, out.vectors);
                }),
            row("solid_rates", SolidRateSums<Dim>{}, 1 + Dim * Dim, [](const Sample& s, Precision p, Out& out) {
                solid_rates<Dim>(s.medium.view(), s.list, p, out.scalars, out.tensors);
            })};
}

template <int Dim>
std::vector<PassRow<Boundary<Dim>>> wall_passes() {
    using Sample = Boundary<Dim>;
    using Out = Output<Dim>;
    const auto of_wall = [](const char* name, auto pass, int written, auto run) {
        return PassRow<Sample>{name,
                               run,
                               &Sample::backing,
                               &Sample::fluid,
                               &Sample::backing_fluid,
                               operations_per_lane(pass),
                               columns_of_pass<decltype(pass)>(written)};
    };
    const auto of_fluid = [](const char* name, auto pass, int written, auto run) {
        return PassRow<Sample>{name,
                               run,
                               &Sample::fluid,
                               &Sample::backing,
                               &Sample::fluid_backing,
                               operations_per_lane(pass),
                               columns_of_pass<decltype(pass)>(written)};
    };
    return {of_wall("wall_pressure", GhostPressureSums<Dim>{}, 1,
                    [](const Sample& s, Precision p, Out& out) {
                        fixed_ghost_pressure<Dim>(s.backing.view(), s.fluid.view(), s.backing_fluid, {}, p, out.scalars);
                    }),
            of_fluid("wall_force", GhostPressure<Dim>{}, Dim,
                     [](const Sample& s, Precision p, Out& out) {
                         fixed_ghost_force<Dim>(s.fluid.view(), s.backing.view(), s.fluid_backing, p, out.vectors);
                     }),
            of_fluid("wall_continuity", GhostContinuity<Dim>{}, 1, [](const Sample& s, Precision p, Out& out) {
                fixed_ghost_continuity<Dim>(s.fluid.view(), s.backing.view(), s.fluid_backing, p, out.scalars);
            })};
}

/// The interface's passes know no precision.
template <int Dim>
std::vector<PassRow<Boundary<Dim>>> interface_passes() {
    using Sample = Boundary<Dim>;
    using Out = Output<Dim>;
    using Side = Medium<Dim> Sample::*;
    using List = NeighborList Sample::*;
    const auto row = [](const char* name, auto pass, Side queries, Side candidates, List list, int written, auto run) {
        return PassRow<Sample>{name,
                               run,
                               queries,
                               candidates,
                               list,
                               operations_per_lane(pass),
                               columns_of_pass<decltype(pass)>(written)};
    };
    return {row("interface_pressure", ElementPressure<Dim>{}, &Sample::elements, &Sample::fluid,
                &Sample::element_fluid, 1,
                [](const Sample& s, Precision, Out& out) {
                    add_interface_pressure<Dim>(s.elements.view(), s.fluid.view(), s.element_fluid, out.scalars);
                }),
            row("interface_weights", ElementWeights<Dim>{}, &Sample::elements, &Sample::backing,
                &Sample::element_backing, 1 + Dim,
                [](const Sample& s, Precision, Out& out) {
                    interface_weights<Dim>(s.elements.view(), s.backing.view(), s.element_backing, out.scalars,
                                           out.vectors);
                }),
            row("interface_force_on_solid", ForceShare<Dim>{}, &Sample::backing, &Sample::elements,
                &Sample::backing_element, Dim,
                [](const Sample& s, Precision, Out& out) {
                    interface_force_on_solid<Dim>(s.backing.view(), s.elements.view(), s.backing_element, out.totals,
                                                  out.vectors);
                }),
            row("interface_force_on_fluid", SurfaceIntegral<Dim>{}, &Sample::fluid, &Sample::elements,
                &Sample::fluid_element, Dim,
                [](const Sample& s, Precision, Out& out) {
                    add_interface_force_on_fluid<Dim>(s.fluid.view(), s.elements.view(), s.fluid_element, out.totals,
                                                      out.vectors);
                }),
            row("interface_continuity", SurfaceFlux<Dim>{}, &Sample::fluid, &Sample::elements, &Sample::fluid_element,
                1, [](const Sample& s, Precision, Out& out) {
                    add_interface_continuity<Dim>(s.fluid.view(), s.elements.view(), s.fluid_element, out.scalars);
                })};
}

struct Arguments {
    int h_over_d;  ///< in hundredths
    std::size_t particles;
    Precision precision;
    Isa isa;
    int threads;
};

std::string text_of(const Arguments& a, int dim) {
    return "/dim:" + std::to_string(dim) + "/h:" + std::to_string(a.h_over_d) + "/n:" + std::to_string(a.particles) +
           (a.precision == Precision::mixed ? "/mixed/" : "/full/") + std::string(name_of(a.isa)) +
           "/threads:" + std::to_string(a.threads);
}

/// The sample used last: benchmarks that follow each other mostly share it.
template <class Sample>
const Sample& sample_of(const Arguments& a) {
    static std::unique_ptr<Sample> sample;
    static std::size_t particles;
    static int h_over_d;
    if (!sample || particles != a.particles || h_over_d != a.h_over_d) {
        sample.reset();
        sample = std::make_unique<Sample>(a.particles, 0.01 * a.h_over_d);
        particles = a.particles;
        h_over_d = a.h_over_d;
    }
    return *sample;
}

/// Work per iteration as a rate; kIsIterationInvariantRate makes a fraction of it if it is divided by a limit.
benchmark::Counter per_second(double work) { return {work, benchmark::Counter::kIsIterationInvariantRate}; }

template <class Sample>
void count(benchmark::State& state, const PassRow<Sample>& pass, const Arguments& a, const Sample& sample) {
    const NeighborList& list = sample.*pass.list;
    const auto pairs = static_cast<double>(list.pairs()), particles = static_cast<double>(list.size());
    const double lanes = 16 * static_cast<double>(list.cluster_pairs());
    const bool one_set = pass.queries == pass.candidates;
    const double of_list = list_bytes(list);
    const double of_columns = column_bytes(pass.columns, list.size(), one_set ? 0 : (sample.*pass.candidates).size());
    state.counters["pairs/s"] = per_second(pairs);
    state.counters["of_fma_peak"] = per_second(pass.operations * lanes / arithmetic_peak(a.isa, a.precision));
    state.counters["of_copy"] = per_second((of_list + of_columns) / copy_rate().memory);
    state.counters["pairs/particle"] = pairs / particles;
    state.counters["lanes/pair"] = lanes / pairs;
    state.counters["operations/lane"] = pass.operations;
    state.counters["list_bytes/particle"] = of_list / particles;
    state.counters["column_bytes/particle"] = of_columns / particles;
}

template <class Sample>
void run_pass(benchmark::State& state, const PassRow<Sample>& pass, const Arguments& a) {
    omp_set_num_threads(a.threads);
    use_isa(name_of(a.isa));
    const Sample& sample = sample_of<Sample>(a);
    Output<Sample::dim> output((sample.*pass.queries).size());
    for (auto _ : state) {
        pass.run(sample, a.precision, output);
        benchmark::ClobberMemory();
    }
    count(state, pass, a, sample);
}

template <class Sample>
void register_pass(const PassRow<Sample>& pass, const Arguments& a, const std::string& folder = "") {
    const std::string name = folder + pass.name + text_of(a, Sample::dim);
    benchmark::RegisterBenchmark(name.c_str(), run_pass<Sample>, pass, a)->MeasureProcessCPUTime();
}

/// Both precisions where the pass knows them.
using Precisions = std::vector<Precision>;

template <class Sample>
void register_passes(const std::vector<PassRow<Sample>>& passes, const Precisions& precisions) {
    for (const int h : {120, 150})
        for (const std::size_t n : {10'000U, 100'000U})
            for (const auto& pass : passes)
                for (const Precision precision : precisions) {
                    for (const Isa isa : available_isas()) register_pass(pass, {h, n, precision, isa, 1});
                    if (h == 150 && n == 100'000)
                        register_pass(pass, {h, n, precision, available_isas().back(), 2});
                }
}

template <class Sample>
void register_large(const std::vector<PassRow<Sample>>& passes, const Precisions& precisions) {
    for (const auto& pass : passes)
        for (const Precision precision : precisions)
            register_pass(pass, {120, 1'000'000, precision, available_isas().back(), 1}, "large/");
}

template <int Dim>
void register_dimension() {
    const Precisions both{Precision::mixed, Precision::full};
    register_passes(cube_passes<Dim>(), both);
    register_passes(wall_passes<Dim>(), both);
    register_passes(interface_passes<Dim>(), {Precision::full});
}

}  // namespace

void register_passes() {
    register_dimension<2>();
    register_dimension<3>();
    register_large(cube_passes<3>(), {Precision::mixed, Precision::full});
}

}  // namespace sluice::bench
