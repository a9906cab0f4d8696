// Pair passes between the fluid and a solid's particles as its moving boundary (kernels/terms/moving_boundary.hpp).
// Lists hold pairs within the support of their mean smoothing length.
#pragma once

#include "kernels/block_loop.hpp"
#include "kernels/block_totals.hpp"

namespace sluice {

/// acceleration of the fluid += F_f/m_f for listed particles. Returns Σ_f F_f [N; N/m in 2D].
template <int Dim>
Vec<Dim> boundary_pressure_on_fluid(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary,
                                    const NeighborList& list, const Vec<Dim>& gravity, const PairMethod<Dim>& method,
                                    BlockTotals<Dim>& totals, VectorField<Dim>& acceleration);

/// force on the boundary's particles += F_s [N; N/m in 2D] for listed particles. Returns Σ_s F_s.
template <int Dim>
Vec<Dim> boundary_reaction(const ParticleView<Dim>& boundary, const ParticleView<Dim>& fluid, const NeighborList& list,
                           const Vec<Dim>& gravity, const PairMethod<Dim>& method, BlockTotals<Dim>& totals,
                           VectorField<Dim>& force);

/// density_rate of the fluid += approach to the boundary (MovingBoundaryContinuity).
template <int Dim>
void boundary_continuity(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary, const NeighborList& list,
                         const PairMethod<Dim>& method, ScalarField& density_rate);

}  // namespace sluice
