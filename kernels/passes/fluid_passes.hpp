// Pair passes of the fluid. Each adds to its output and returns the directed pairs inside the support.
#pragma once

#include <cstdint>

#include "kernels/choices.hpp"
#include "kernels/pairs/block_loop.hpp"

namespace sluice {

/// Constants of the fluid's terms. A viscosity of zero takes the viscous term out of the momentum loop.
struct FluidTerms {
    double artificial_viscosity = 0;  ///< α
    double sound_speed = 0;           ///< c0 [m/s]
    Viscosity viscosity = Viscosity::artificial;
    double kinematic_viscosity = 0;  ///< ν of the laminar ones [m²/s]
    bool multiphase = false;         ///< several fluids (kernels/terms/multiphase.hpp); reads their sound_speed
};

/// acceleration += eq. (10) without gravity.
template <int Dim>
std::uint64_t fluid_momentum(const ParticleView<Dim>& fluid, const NeighborList& list, const FluidTerms& terms,
                             const PairMethod<Dim>& method, VectorField<Dim>& acceleration);

/// density_rate += eq. (8), for a fluid as for a solid.
template <int Dim>
std::uint64_t continuity(const ParticleView<Dim>& particles, const NeighborList& list, const PairMethod<Dim>& method,
                         ScalarField& density_rate);

/// Velocity filter, eq. (16): correction_i = (1 − θ) Σ_j V_j (v_j − v_i) W_ij / Σ_j V_j W_ij, V_j = m_j/ρ̄_ij, the sum
/// in the denominator with the particle itself, which must stand in its own list. Particles that are not listed get
/// zero.
template <int Dim>
std::uint64_t velocity_filter(const ParticleView<Dim>& particles, const NeighborList& list, double theta,
                              const PairMethod<Dim>& method, VectorField<Dim>& correction);

}  // namespace sluice
