// Pair passes between the fluid and a solid's particles as its moving boundary (kernels/terms/moving_boundary.hpp).
// Lists hold pairs within the support of their mean smoothing length.
#pragma once

#include "kernels/pairs/block_loop.hpp"
#include "kernels/pairs/block_totals.hpp"

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

/// ghost_velocity = 2 v_w − ṽ for listed particles, from v_w in it; where no fluid is near it stays v_w.
/// (kernels/terms/boundary_viscosity.hpp)
template <int Dim>
void boundary_ghost_velocity(const ParticleView<Dim>& boundary, const ParticleView<Dim>& fluid,
                             const NeighborList& list, const PairMethod<Dim>& method, VectorField<Dim>& ghost_velocity);

/// acceleration of the fluid += friction. The boundary's velocity column is the ghosts'. Returns Σ_f F_f.
template <int Dim>
Vec<Dim> boundary_friction(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary, const NeighborList& list,
                           double viscosity, const PairMethod<Dim>& method, BlockTotals<Dim>& totals,
                           VectorField<Dim>& acceleration);

/// force on the boundary's particles += the opposite. Returns Σ_w F_w.
template <int Dim>
Vec<Dim> boundary_friction_reaction(const ParticleView<Dim>& boundary, const ParticleView<Dim>& fluid,
                                    const NeighborList& list, double viscosity, const PairMethod<Dim>& method,
                                    BlockTotals<Dim>& totals, VectorField<Dim>& force);

}  // namespace sluice
