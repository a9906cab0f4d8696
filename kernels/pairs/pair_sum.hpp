// Sums over pairs for all particles of a list, on all threads.
#pragma once

#include <omp.h>

#include "kernels/pairs/block_loop.hpp"
#include "kernels/pairs/pass_name.hpp"
#include "neighbor/loop_watch.hpp"

namespace sluice {

/// With fewer pairs of clusters than this, some ten microseconds of work, the calling thread works alone.
inline constexpr std::uint64_t parallel_cluster_pairs = 256;

/// Describes the loop over a pass's pairs for profiles.
template <class Pass>
const Section& section_of(Precision precision) {
    static constexpr Section in_double{pass_name<Pass>, sizeof(double), counted::operations_per_lane<Pass>};
    static constexpr Section in_single{pass_name<Pass>, sizeof(float), counted::operations_per_lane<Pass>};
    return is_full<Pass>(precision) ? in_double : in_single;
}

/// Memory traffic: each column that is read counts once, each that is written twice. How many different candidates
/// there are is known only if they are the queries; otherwise one that is near several blocks counts for each.
template <class Pass>
PairWork pair_work(const ParticleView<Pass::dim>& a, const ParticleView<Pass::dim>& b, const NeighborList& list) {
    constexpr int dim = Pass::dim;
    constexpr std::size_t of_i = Slots<dim, Pass::reads_i>::count, of_j = Slots<dim, Pass::reads_j>::count,
                          of_both = Slots<dim, Pass::reads_i | Pass::reads_j>::count, written = Pass::outputs;
    const bool one_set = a.position == b.position;
    const std::size_t read =
        one_set ? of_both * list.size() : of_i * list.size() + of_j * cluster_size * list.candidate_clusters();
    return {list.size(), list.pairs(), list.cluster_pairs() * cluster_size * cluster_size, list.loop_bytes(),
            sizeof(double) * (read + 2 * written * list.size())};
}

/// store(block, i, Σ_j pass(ij)) for every listed particle. Blocks are dealt out by work. Returns the directed pairs
/// inside the support.
template <class Pass, class Store>
std::uint64_t sum_pairs_by_block(const Pass& pass, const PairMethod<Pass::dim>& method,
                                 const ParticleView<Pass::dim>& a, const ParticleView<Pass::dim>& b,
                                 const NeighborList& list, const Store& store) {
    const BlockLoop<Pass> loop = block_loop<Pass>(method.precision);
    const BlockTask<Pass::dim> task{a, b, list.view(), method.smoothing};
    WatchedSection section(section_of<Pass>(method.precision));
    if (section.is_watched()) section.set_work(pair_work<Pass>(a, b, list));
    const WatchedLoop watched;
#pragma omp parallel if (list.cluster_pairs() > parallel_cluster_pairs)
    {
        const WatchedShare watched_share(watched);
        double sums[block_particles * Pass::outputs];
        const Range share = list.share(omp_get_thread_num(), omp_get_num_threads());
        for (Index n = share.begin; n < share.end; ++n) {
            const ListView::Block& block = task.list.block[n];
            loop(task, block, pass, sums);
            const double* sum = sums;
            for (Index q = block.queries.begin; q < block.queries.end; ++q, sum += cluster_size * Pass::outputs) {
                const double* of_lane = sum;
                list.for_queries(q, [&](Index i) {
                    Vec<Pass::outputs> value;
                    for (int k = 0; k < Pass::outputs; ++k) value[k] = of_lane[cluster_size * static_cast<Index>(k)];
                    store(n, i, value);
                    ++of_lane;
                });
            }
        }
    }
    return list.pairs();
}

/// store(i, Σ_j pass(ij)) for every listed particle.
template <class Pass, class Store>
std::uint64_t sum_pairs(const Pass& pass, const PairMethod<Pass::dim>& method, const ParticleView<Pass::dim>& a,
                        const ParticleView<Pass::dim>& b, const NeighborList& list, const Store& store) {
    return sum_pairs_by_block(pass, method, a, b, list,
                              [&store](Index, Index i, const Vec<Pass::outputs>& sum) { store(i, sum); });
}

/// out_i += Σ_j pass(ij)
template <class Pass>
std::uint64_t add_vectors(const Pass& pass, const PairMethod<Pass::dim>& method, const ParticleView<Pass::dim>& a,
                          const ParticleView<Pass::dim>& b, const NeighborList& list, VectorField<Pass::dim>& out) {
    return sum_pairs(pass, method, a, b, list,
                     [&out](Index i, const Vec<Pass::dim>& sum) { out.set(i, out[i] + sum); });
}
template <class Pass>
std::uint64_t add_scalars(const Pass& pass, const PairMethod<Pass::dim>& method, const ParticleView<Pass::dim>& a,
                          const ParticleView<Pass::dim>& b, const NeighborList& list, ScalarField& out) {
    return sum_pairs(pass, method, a, b, list, [&out](Index i, const Vec<1>& sum) { out[i] += sum[0]; });
}

}  // namespace sluice
