// Rigid walls made of layers of fixed ghost particles.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/pairs/block_loop.hpp"

namespace sluice {

/// The pressure of each ghost, taken from the fluid in front of it: the mean over the fluid neighbours, each brought to
/// the ghost's place by the hydrostatic gradient [Adami, Hu & Adams 2012, eq. 27],
///   p_w = Σ_f V_f (p_f + ρ_f g·(x_w − x_f)) W_wf / Σ_f V_f W_wf,   and 0 where it would be negative:
/// a smooth rigid wall pushes water but does not hold it. A ghost has no memory: with no fluid near, p_w = 0.
template <int Dim>
std::uint64_t fixed_ghost_pressure(const ParticleView<Dim>& wall, const ParticleView<Dim>& fluid,
                                   const NeighborList& list, const Vec<Dim>& gravity, const PairMethod<Dim>& method,
                                   ScalarField& pressure);

/// The same for walls that move: in the frame of wall w, gravity is g − a_w [Adami, Hu & Adams 2012, eq. 25].
/// effective_gravity: of each wall by its number, body: the number of each ghost's wall.
template <int Dim>
std::uint64_t moving_ghost_pressure(const ParticleView<Dim>& wall, const ParticleView<Dim>& fluid,
                                    const NeighborList& list, const std::vector<Vec<Dim>>& effective_gravity,
                                    const Array<std::uint16_t>& body, const PairMethod<Dim>& method,
                                    ScalarField& pressure);

/// acceleration of the fluid += the ghosts' pressure (FixedGhostPressure).
template <int Dim>
std::uint64_t fixed_ghost_force(const ParticleView<Dim>& fluid, const ParticleView<Dim>& wall, const NeighborList& list,
                                const PairMethod<Dim>& method, VectorField<Dim>& acceleration);

/// density_rate of the fluid += approach to the ghosts (FixedGhostContinuity).
template <int Dim>
std::uint64_t fixed_ghost_continuity(const ParticleView<Dim>& fluid, const ParticleView<Dim>& wall,
                                     const NeighborList& list, const PairMethod<Dim>& method,
                                     ScalarField& density_rate);

}  // namespace sluice
