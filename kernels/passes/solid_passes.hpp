// Pair passes of the solid, and what follows them particle by particle.
#pragma once

#include <cstdint>

#include "kernels/pairs/block_loop.hpp"

namespace sluice {

/// Constants of the solid's terms. α = 0 or e = 0 takes the term out of the loop.
struct SolidTerms {
    double artificial_viscosity = 0;     ///< α
    double sound_speed = 0;              ///< c0 [m/s]
    double artificial_stress = 0;        ///< e
    int artificial_stress_exponent = 4;  ///< q
    double h_over_d = 0;                 ///< smoothing length over initial spacing
    bool multiphase = false;             ///< several materials (kernels/terms/multiphase.hpp); reads sound_speed
};

/// What stands before the sum in eq. (8): the partners' masses, or their volumes where densities differ.
enum class DensitySum { by_mass, by_volume };

/// acceleration += eq. (11) without gravity.
template <int Dim>
std::uint64_t solid_momentum(const ParticleView<Dim>& solid, const NeighborList& list, const SolidTerms& terms,
                             const PairMethod<Dim>& method, VectorField<Dim>& acceleration);

/// density_rate += eq. (8) and velocity_gradient = eq. (15), in one loop.
///
/// Eq. (15): expand v_b to first order about a in Σ_b V_b (v_b − v_a) ⊗ ∇W. With G = Σ_b V_b (v_b − v_a) ⊗ ∇_a W_ab and
/// M = Σ_b V_b (x_b − x_a) ⊗ ∇_a W_ab it reads G = L M, so L = G M⁻¹: exact for every linear velocity field, at a free
/// surface too. A particle with too few neighbours to define M (det M < 10⁻³, where a full support has 1) gets L = 0.
template <int Dim>
std::uint64_t solid_rates(const ParticleView<Dim>& solid, const NeighborList& list, const PairMethod<Dim>& method,
                          ScalarField& density_rate, TupleField<Dim * Dim>& velocity_gradient,
                          DensitySum density_sum = DensitySum::by_mass);

}  // namespace sluice
