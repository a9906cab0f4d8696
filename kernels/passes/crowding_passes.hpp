// Particles that come too close to others.
#pragma once

#include <cstdint>

#include "kernels/pairs/block_loop.hpp"

namespace sluice {

/// crowding = Σ_j max(1 − |x_ij|²/(c h_ij)², 0) for listed particles of a, over b: 0 if none is nearer than c h. With
/// one neighbour that near, at r, it is 1 − r²/(c h)². A particle that stands in both has 1 of itself. Others keep what
/// they have. c = `reach_over_h`.
template <int Dim>
std::uint64_t crowding_of(const ParticleView<Dim>& a, const ParticleView<Dim>& b, const NeighborList& list,
                          double reach_over_h, ScalarField& crowding);

}  // namespace sluice
