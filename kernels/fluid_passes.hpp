// Pair passes of the fluid. Each adds to its output; templated on dimension and on the real type of pair arithmetic.
#pragma once

#include <cstdint>

#include "kernels/pair.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice {

/// Which smoothing function the passes use.
template <int Dim>
using DefaultSmoothing = CubicSpline<Dim>;

/// Constants of the fluid's terms. α = 0 takes the viscous term out of the loop.
struct FluidTerms {
    double artificial_viscosity = 0;  ///< α
    double sound_speed = 0;           ///< c0 [m/s]
};

/// acceleration += eq. (10) without gravity. Returns the directed pairs inside the support.
template <int Dim, class Real>
std::uint64_t fluid_momentum(const ParticleView<Dim>& fluid, const NeighborList& list, const FluidTerms& terms,
                             VectorField<Dim>& acceleration);

/// density_rate += eq. (8), for a fluid as for a solid.
template <int Dim, class Real>
std::uint64_t continuity(const ParticleView<Dim>& particles, const NeighborList& list, ScalarField& density_rate);

/// Velocity filter, eq. (16): correction_i = (1 − θ) Σ_j V_j (v_j − v_i) W_ij / Σ_j V_j W_ij, V_j = m_j/ρ̄_ij, the sum
/// in the denominator with the particle itself, which must stand in its own list (group size above 1). Particles that
/// are not listed get zero.
template <int Dim, class Real>
std::uint64_t velocity_filter(const ParticleView<Dim>& particles, const NeighborList& list, double theta,
                              VectorField<Dim>& correction);

}  // namespace sluice
