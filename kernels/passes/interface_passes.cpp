#include "kernels/passes/interface_passes.hpp"

#include <algorithm>

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/interface_loops.hpp"

namespace sluice {
template <int Dim>
void add_interface_pressure(const ParticleView<Dim>& elements, const ParticleView<Dim>& fluid, const NeighborList& list,
                            const PairMethod<Dim>& method, ScalarField& pressure) {
    sum_pairs(ElementPressure<Dim>{}, method, elements, fluid, list,
              [&](Index k, const Vec<1>& sum) { pressure[k] += sum[0]; });
}

template <int Dim>
void interface_weights(const ParticleView<Dim>& elements, const ParticleView<Dim>& solid, const NeighborList& list,
                       const PairMethod<Dim>& method, ScalarField& weight, VectorField<Dim>& velocity) {
    std::fill(weight.begin(), weight.end(), 0.0);
    sum_pairs(ElementWeights<Dim>{}, method, elements, solid, list, [&](Index k, const Vec<Dim + 1>& sum) {
        weight[k] = sum[0];
        Vec<Dim> v;
        for (int c = 0; c < Dim; ++c) v[c] = sum[0] > 0 ? sum[1 + c] / sum[0] : 0.0;
        velocity.set(k, v);
    });
}

template <int Dim>
Vec<Dim> interface_force_on_solid(const ParticleView<Dim>& solid, const ParticleView<Dim>& elements,
                                  const NeighborList& list, const PairMethod<Dim>& method, BlockTotals<Dim>& totals,
                                  VectorField<Dim>& acceleration) {
    totals.assign(list.blocks(), {});
    sum_pairs_by_block(ForceShare<Dim>{}, method, solid, elements, list,
                       [&](Index block, Index a, const Vec<Dim>& sum) {
                           const Vec<Dim> acceleration_a = (1 / solid.density[a]) * sum;
                           acceleration.set(a, acceleration_a);
                           totals[block] += solid.mass[a] * acceleration_a;
                       });
    return total_of(totals);
}

template <int Dim>
Vec<Dim> add_interface_force_on_fluid(const ParticleView<Dim>& fluid, const ParticleView<Dim>& elements,
                                      const NeighborList& list, const PairMethod<Dim>& method, BlockTotals<Dim>& totals,
                                      VectorField<Dim>& acceleration) {
    totals.assign(list.blocks(), {});
    sum_pairs_by_block(SurfaceIntegral<Dim>{}, method, fluid, elements, list,
                       [&](Index block, Index b, const Vec<Dim>& sum) {
                           const double volume = fluid.mass[b] / fluid.density[b];
                           const Vec<Dim> force = (2 * volume * fluid.pressure[b]) * sum;
                           acceleration.set(b, acceleration[b] + (1 / fluid.mass[b]) * force);
                           totals[block] += force;
                       });
    return total_of(totals);
}

template <int Dim>
void add_interface_continuity(const ParticleView<Dim>& fluid, const ParticleView<Dim>& elements,
                              const NeighborList& list, const PairMethod<Dim>& method, ScalarField& density_rate) {
    sum_pairs(SurfaceFlux<Dim>{}, method, fluid, elements, list,
              [&](Index b, const Vec<1>& sum) { density_rate[b] -= 2 * fluid.density[b] * sum[0]; });
}

#define SLUICE_INSTANTIATE(Dim)                                                                                        \
    template void add_interface_pressure<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&, const NeighborList&, \
                                              const PairMethod<Dim>&, ScalarField&);                                   \
    template void interface_weights<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&, const NeighborList&,      \
                                         const PairMethod<Dim>&, ScalarField&, VectorField<Dim>&);                     \
    template Vec<Dim> interface_force_on_solid<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,                \
                                                    const NeighborList&, const PairMethod<Dim>&, BlockTotals<Dim>&,    \
                                                    VectorField<Dim>&);                                                \
    template Vec<Dim> add_interface_force_on_fluid<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,            \
                                                        const NeighborList&, const PairMethod<Dim>&,                   \
                                                        BlockTotals<Dim>&, VectorField<Dim>&);                         \
    template void add_interface_continuity<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,                    \
                                                const NeighborList&, const PairMethod<Dim>&, ScalarField&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
