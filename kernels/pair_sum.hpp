// Sums over pairs for all particles of a list, on all threads.
#pragma once

#include <omp.h>

#include <type_traits>

#include "kernels/block_loop.hpp"
#include "kernels/pair.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

/// Below this many pairs of clusters, some ten microseconds of work, the calling thread does it alone.
inline constexpr std::uint64_t parallel_cluster_pairs = 256;

/// store(block, i, Σ_j pass(ij)) for every listed particle. Blocks are dealt out by work. Returns the directed pairs
/// inside the support.
template <class Pass, class Store>
std::uint64_t sum_pairs_by_block(const Pass& pass, const PairMethod<Pass::dim>& method,
                                 const ParticleView<Pass::dim>& a, const ParticleView<Pass::dim>& b,
                                 const NeighborList& list, const Store& store) {
    const BlockLoop<Pass> loop = block_loop<Pass>(method.precision);
    const BlockTask<Pass::dim> task{a, b, list.view(), method.smoothing};
#pragma omp parallel if (list.cluster_pairs() > parallel_cluster_pairs)
    {
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

/// Accelerations Σ_j m_j T_ij ∇_i W_ij. A term returns its share of T: a symmetric tensor, or a scalar that stands for
/// a multiple of the unit tensor. Terms that a scene lacks are not in the pack.
template <int Dim, class... Terms>
struct MomentumTerms : Terms... {
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr unsigned reads_i = (Terms::reads_i | ...), reads_j = column::mass | (Terms::reads_j | ...);

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ij) const {
        const auto t = sum_of<typename Pair::Real>(Terms::operator()(ij)...);
        if constexpr (std::is_same_v<std::decay_t<decltype(t)>, typename Pair::Real>)
            return (t * ij.m_grad_w_over_x()) * ij.x_ij;
        else
            return ij.m_grad_w_over_x() * sym_times<Dim>(t, ij.x_ij);
    }

  private:
    template <class Real, class T>
    [[gnu::always_inline]] static T sum_of(const T& t) {
        return t;
    }
    template <class Real, class T, class U, class... Rest>
    [[gnu::always_inline]] static auto sum_of(const T& t, const U& u, const Rest&... rest) {
        if constexpr (std::is_same_v<T, U>)
            return sum_of<Real>(T(t + u), rest...);
        else if constexpr (std::is_same_v<U, Real>) {
            T sum = t;  // the diagonal comes first
            unroll<Dim>([&](int k) __attribute__((always_inline)) { sum[k] += u; });
            return sum_of<Real>(sum, rest...);
        } else
            return sum_of<Real>(u, t, rest...);
    }
};

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
