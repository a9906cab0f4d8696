// The loop over pairs, written once: each particle gathers from its own partners, in the list's order, so that the sums
// have the same bits for any number of threads.
//
// Particles come in groups of neighbours in space that share one candidate list. The candidates are gathered once into
// a tile in the first-level cache; each of the group's particles then goes over the tile's lanes without a branch and
// without indirection, which the compiler turns into vector code. Candidates outside a particle's support add zero.
#pragma once

#include "kernels/tile.hpp"
#include "neighbor/isa.hpp"
#include "neighbor/neighbor_list.hpp"
#include "neighbor/parallel.hpp"

// Tells the compiler that the iterations of the loop below do not depend on each other. (omp simd says so too, but
// makes arrays of every object declared in the loop, which GCC then cannot take apart into vector registers.)
#if defined(__clang__)
#define SLUICE_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety)")
#else
#define SLUICE_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#endif

namespace sluice {
namespace {  // the compiler's clones must not be merged with those of another file

/// Σ of a multiple of lane_multiple numbers: lane by lane, then as a tree.
template <class Real>
[[gnu::always_inline]] inline Real sum_of_lanes(const Real* values, int lanes) {
    constexpr int width = lane_multiple<Real>;
    Real part[width] = {};
    for (int l = 0; l < lanes; l += width)
        for (int k = 0; k < width; ++k) part[k] += values[l + k];
    for (int half = width / 2; half > 0; half /= 2)
        for (int k = 0; k < half; ++k) part[k] += part[k + half];
    return part[0];
}

/// Adds map(pair) → Out[] over the tile's lanes to sums[]. EqualH: the whole tile and i have one smoothing length.
template <bool EqualH, class Smoothing, int Outputs, int Dim, class Real, unsigned ReadsI, unsigned ReadsJ, class Map>
[[gnu::always_inline]] inline void sum_over_lanes(const Self<Dim, Real, ReadsI>& self,
                                                  const Tile<Dim, Real, ReadsJ>& tile, int lanes, const Map& map,
                                                  double* sums) {
    alignas(64) Real out[Outputs][tile_capacity];
    const Real self_inverse_h = Real(1) / self.smoothing_length;
    const Real self_scale = kernel_scale<Smoothing, Dim>(self_inverse_h);
    SLUICE_INDEPENDENT_ITERATIONS
    for (int l = 0; l < (lanes & -lane_multiple<Real>); ++l) {
        Vec<Dim, Real> x_ij;
        unroll<Dim>([&](int k) { x_ij[k] = self.position[k] - tile.position[k][l]; });
        const Real h = EqualH ? self.smoothing_length : Real(0.5) * (self.smoothing_length + tile.smoothing_length[l]);
        const Real inverse_h = EqualH ? self_inverse_h : Real(1) / h;
        const Real scale = EqualH ? self_scale : kernel_scale<Smoothing, Dim>(inverse_h);
        const Pair<Dim, Real, Smoothing, Self<Dim, Real, ReadsI>, Tile<Dim, Real, ReadsJ>> pair{
            self, tile, l, x_ij, norm2(x_ij), h, inverse_h, scale};
        const Vec<Outputs, Real> value = map(pair);
        unroll<Outputs>([&](int k) { out[k][l] = value[k]; });
    }
    for (int k = 0; k < Outputs; ++k) sums[k] += static_cast<double>(sum_of_lanes(out[k], lanes));
}

/// One group: store(i, sums) for each of its particles.
template <bool EqualH, class Smoothing, unsigned ReadsI, unsigned ReadsJ, int Outputs, class Real, int Dim, class Map,
          class Store>
SLUICE_ISA_CLONES void sum_group(const ParticleView<Dim>& a, const ParticleView<Dim>& b, std::span<const Index> queries,
                                 std::span<const Index> candidates, const Map& map, const Store& store) {
    Tile<Dim, Real, ReadsJ> tile;
    Vec<Outputs> sums[max_group_size] = {};
    const Vec<Dim> origin = at<double>(a.position, queries[0]);
    while (!candidates.empty()) {
        const auto chunk = candidates.first(std::min<std::size_t>(candidates.size(), tile_capacity));
        candidates = candidates.subspan(chunk.size());
        const int lanes = tile.template gather<EqualH>(b, chunk, origin);
        for (std::size_t q = 0; q < queries.size(); ++q)
            sum_over_lanes<EqualH, Smoothing, Outputs>(Self<Dim, Real, ReadsI>(a, queries[q], origin), tile, lanes, map,
                                                       sums[q].c.data());
    }
    for (std::size_t q = 0; q < queries.size(); ++q) store(queries[q], sums[q]);
}

/// The list's reaches are the smoothing lengths, as for every list between particles.
/// store(i, Σ_j map(ij)) for every listed particle, on all threads; map returns Vec<Outputs, Real>. Returns the number
/// of directed pairs inside the support.
template <class Smoothing, unsigned ReadsI, unsigned ReadsJ, int Outputs, class Real, int Dim, class Map, class Store>
std::uint64_t sum_pairs(const ParticleView<Dim>& a, const ParticleView<Dim>& b, const NeighborList& list,
                        const Map& map, const Store& store) {
    const auto groups = static_cast<std::int64_t>(list.groups());
#pragma omp parallel for schedule(dynamic, 16) if (list.size() > parallel_threshold)
    for (std::int64_t g = 0; g < groups; ++g) {
        const auto group = static_cast<std::size_t>(g);
        const auto queries = list.queries(group), candidates = list.candidates(group);
        if (list.equal_reach(group))
            sum_group<true, Smoothing, ReadsI, ReadsJ, Outputs, Real>(a, b, queries, candidates, map, store);
        else
            sum_group<false, Smoothing, ReadsI, ReadsJ, Outputs, Real>(a, b, queries, candidates, map, store);
    }
    return list.pairs();
}

/// out_i += Σ_j (term(ij) + …), vector-valued terms. Terms that a scene lacks are not in the pack.
template <class Real, class Smoothing, int Dim, class... Terms>
std::uint64_t gather_vectors(const ParticleView<Dim>& a, const ParticleView<Dim>& b, const NeighborList& list,
                             VectorField<Dim>& out, const Terms&... terms) {
    return sum_pairs<Smoothing, (Terms::reads_i | ...), (Terms::reads_j | ...), Dim, Real>(
        a, b, list, [=](const auto& ij) { return (terms(ij) + ...); },
        [&out](Index i, const Vec<Dim>& sum) { out.set(i, out[i] + sum); });
}

/// out_i += Σ_j (term(ij) + …), scalar-valued terms.
template <class Real, class Smoothing, int Dim, class... Terms>
std::uint64_t gather_scalars(const ParticleView<Dim>& a, const ParticleView<Dim>& b, const NeighborList& list,
                             ScalarField& out, const Terms&... terms) {
    return sum_pairs<Smoothing, (Terms::reads_i | ...), (Terms::reads_j | ...), 1, Real>(
        a, b, list, [=](const auto& ij) { return Vec<1, Real>{{(terms(ij) + ...)}}; },
        [&out](Index i, const Vec<1>& sum) { out[i] += sum[0]; });
}

}  // namespace
}  // namespace sluice
