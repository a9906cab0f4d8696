#include "kernels/passes/crowding_passes.hpp"

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/crowding_loops.hpp"

namespace sluice {

template <int Dim>
std::uint64_t crowding_of(const ParticleView<Dim>& a, const ParticleView<Dim>& b, const NeighborList& list,
                          double reach_over_h, ScalarField& crowding) {
    const Crowding<Dim> pass{1 / (reach_over_h * reach_over_h)};
    return sum_pairs(pass, PairMethod<Dim>{}, a, b, list, [&](Index i, const Vec<1>& sum) { crowding[i] = sum[0]; });
}

template std::uint64_t crowding_of<2>(const ParticleView<2>&, const ParticleView<2>&, const NeighborList&, double,
                                      ScalarField&);
template std::uint64_t crowding_of<3>(const ParticleView<3>&, const ParticleView<3>&, const NeighborList&, double,
                                      ScalarField&);

}  // namespace sluice
