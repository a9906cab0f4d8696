#include "kernels/passes/boundary_passes.hpp"

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/boundary_loops.hpp"

namespace sluice {

template <int Dim>
Vec<Dim> boundary_pressure_on_fluid(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary,
                                    const NeighborList& list, const Vec<Dim>& gravity, const PairMethod<Dim>& method,
                                    BlockTotals<Dim>& totals, VectorField<Dim>& acceleration) {
    totals.assign(list.blocks(), {});
    sum_pairs_by_block(BoundaryPressure<Dim>{gravity}, method, fluid, boundary, list,
                       [&](Index block, Index f, const Vec<Dim>& sum) {
                           acceleration.set(f, acceleration[f] + sum);
                           totals[block] += fluid.mass[f] * sum;
                       });
    return total_of(totals);
}

template <int Dim>
Vec<Dim> boundary_reaction(const ParticleView<Dim>& boundary, const ParticleView<Dim>& fluid, const NeighborList& list,
                           const Vec<Dim>& gravity, const PairMethod<Dim>& method, BlockTotals<Dim>& totals,
                           VectorField<Dim>& force) {
    totals.assign(list.blocks(), {});
    sum_pairs_by_block(BoundaryReaction<Dim>{gravity}, method, boundary, fluid, list,
                       [&](Index block, Index s, const Vec<Dim>& sum) {
                           const Vec<Dim> of_particle = boundary.volume[s] * sum;
                           force.set(s, force[s] + of_particle);
                           totals[block] += of_particle;
                       });
    return total_of(totals);
}

template <int Dim>
void boundary_continuity(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary, const NeighborList& list,
                         const PairMethod<Dim>& method, ScalarField& density_rate) {
    add_scalars(BoundaryContinuity<Dim>{}, method, fluid, boundary, list, density_rate);
}

template <int Dim>
void boundary_ghost_velocity(const ParticleView<Dim>& boundary, const ParticleView<Dim>& fluid,
                             const NeighborList& list, const PairMethod<Dim>& method,
                             VectorField<Dim>& ghost_velocity) {
    sum_pairs(BoundaryVelocitySums<Dim>{}, method, boundary, fluid, list, [&](Index w, const Vec<Dim + 1>& sum) {
        if (!(sum[0] > 0)) return;
        Vec<Dim> mean;
        for (int k = 0; k < Dim; ++k) mean[k] = sum[1 + k] / sum[0];
        ghost_velocity.set(w, 2 * ghost_velocity[w] - mean);
    });
}

template <int Dim>
Vec<Dim> boundary_friction(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary, const NeighborList& list,
                           double viscosity, const PairMethod<Dim>& method, BlockTotals<Dim>& totals,
                           VectorField<Dim>& acceleration) {
    totals.assign(list.blocks(), {});
    sum_pairs_by_block(BoundaryFrictionPass<Dim>{{viscosity}}, method, fluid, boundary, list,
                       [&](Index block, Index f, const Vec<Dim>& sum) {
                           acceleration.set(f, acceleration[f] + sum);
                           totals[block] += fluid.mass[f] * sum;
                       });
    return total_of(totals);
}

template <int Dim>
Vec<Dim> boundary_friction_reaction(const ParticleView<Dim>& boundary, const ParticleView<Dim>& fluid,
                                    const NeighborList& list, double viscosity, const PairMethod<Dim>& method,
                                    BlockTotals<Dim>& totals, VectorField<Dim>& force) {
    totals.assign(list.blocks(), {});
    sum_pairs_by_block(BoundaryFrictionReactionPass<Dim>{{viscosity}}, method, boundary, fluid, list,
                       [&](Index block, Index w, const Vec<Dim>& sum) {
                           const Vec<Dim> of_particle = boundary.volume[w] * sum;
                           force.set(w, force[w] + of_particle);
                           totals[block] += of_particle;
                       });
    return total_of(totals);
}

#define SLUICE_INSTANTIATE(Dim)                                                                                       \
    template Vec<Dim> boundary_pressure_on_fluid<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,             \
                                                      const NeighborList&, const Vec<Dim>&, const PairMethod<Dim>&,   \
                                                      BlockTotals<Dim>&, VectorField<Dim>&);                          \
    template Vec<Dim> boundary_reaction<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&, const NeighborList&, \
                                             const Vec<Dim>&, const PairMethod<Dim>&, BlockTotals<Dim>&,              \
                                             VectorField<Dim>&);                                                      \
    template void boundary_continuity<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&, const NeighborList&,   \
                                           const PairMethod<Dim>&, ScalarField&);                                     \
    template void boundary_ghost_velocity<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,                    \
                                               const NeighborList&, const PairMethod<Dim>&, VectorField<Dim>&);       \
    template Vec<Dim> boundary_friction<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&, const NeighborList&, \
                                             double, const PairMethod<Dim>&, BlockTotals<Dim>&, VectorField<Dim>&);   \
    template Vec<Dim> boundary_friction_reaction<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,             \
                                                      const NeighborList&, double, const PairMethod<Dim>&,            \
                                                      BlockTotals<Dim>&, VectorField<Dim>&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
