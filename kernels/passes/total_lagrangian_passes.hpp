// An elastic solid in its reference configuration (total Lagrangian SPH) [Vignjevic, Reveles & Campbell 2006;
// Ganzenmüller 2015; O'Connor & Rogers 2021].
//
// A particle's place, and the list, are those before the body was deformed, X: both are made once. V is the
// reference volume. w_ab = −W'(|X_ab|)/|X_ab| ≥ 0, so that ∇_a W_ab = −w_ab X_ab with X_ab = X_a − X_b.
//
// Deformation gradient, exact for every x = A X + c, at corners too:
//   F_a = Σ_b V_b (x_b − x_a) ⊗ L_a ∇_a W_ab,   L_a = M_a⁻¹,   M_a = Σ_b V_b w_ab X_ab ⊗ X_ab                     (a)
// M is symmetric, so there is no question of transposes. F_a is the A that minimises Σ_b V_b w_ab |x_ab − A X_ab|².
//
// Energy. ψ of the material law, and a penalty on what the neighbours' places have beyond F [in the manner of Silling
// 2017; Ganzenmüller 2015 takes its part along the pair]: F alone does not see particles that zigzag.
//   U = Σ_a V_a ψ(F_a) + Σ_a ½ k_a V_a Σ_b V_b w_ab |x_ab − F_a X_ab|²,   k_a = 2 ζ μ                            (b)
// The second sum is zero for every linear x(X). As F_a minimises it, it does not change with F_a, and with P = ∂ψ/∂F
// the force −∂U/∂x_a is a sum over pairs without a sum over the neighbours' neighbours:
//   f_a = V_a Σ_b V_b {(P_a L_a + P_b L_b) ∇_a W_ab − w_ab [k_a (x_ab − F_a X_ab) + k_b (x_ab − F_b X_ab)]}
//       = −V_a Σ_b V_b w_ab {(T_a + T_b) X_ab + (k_a + k_b) x_ab},   T = P L − k F                               (c)
// Equal and opposite within a pair: momentum is kept pair by pair. U does not change when the body is moved or turned,
// so that angular momentum is kept too, though only by all pairs together, and the energy by a symplectic integrator.
//
// Too few neighbours to define L: if the smallest eigenvalue of M is less than 0.01, where a full support has 1 and
// lattices of two layers have 0.014 or more up to h/d = 2, the particle is without stress: L = 0, F = I, k = 0. It
// still feels its neighbours' stress, and (c) is still −∂U/∂x. The other ways out would not do: L = I makes forces when
// the body turns, and the pseudo-inverse gives an F without volume. A row of single particles has no stiffness,
// therefore.
//
// ζ = 0.85, because plates then bend as they should. F of the layers next to a free surface is fitted from one side,
// which makes a plate too soft; the penalty on what is not linear makes it stiffer; both go as (h/thickness)², and
// about there they cancel, whatever Poisson's ratio is. First period of a plate in plane strain, ten times as long as
// thick and clamped (engine/step/parts/clamp_extension.hpp), against finite elements, for ν = 0 to 0.45, h/d = 1 to 1.8,
// cubic spline and Wendland C2: with 4 layers −5 … +2.3 %, with 6 −1.8 … +1.4 %, with 10 −0.5 … +0.7 %. The fastest
// mode of a lattice, which the step must resolve, has ω d/c = 1.36 (2D, h/d = 1.3, ν = 0.3; 1.40 in 3D), c² = (λ +
// 2μ)/ρ, 0.87 without control; layers next to a surface may have faster ones, up to 2.3 in bodies of two layers.
#pragma once

#include <cstdint>
#include <span>

#include "kernels/materials/hyperelastic.hpp"
#include "kernels/pairs/block_loop.hpp"

namespace sluice {

/// ζ, the stiffness against what is not linear over twice the shear modulus.
inline constexpr double usual_hourglass_control = 0.85;

/// Constants of ReferenceViscosity. α = 0 takes it out of the loop.
struct ElasticViscosity {
    double artificial_viscosity = 0;  ///< α
    double sound_speed = 0;           ///< c0 [m/s]
    double density = 0;               ///< ρ0 [kg/m³]
    bool multiphase = false;          ///< several materials: reads their rest_density and sound_speed instead
};

// Constants of the material, `stiffness` and `laws`, are one for all particles or one for each number in the column
// `body`.

/// gradient_correction = L and hourglass_stiffness = k for listed particles, once for a body. `stiffness` is 2 ζ μ
/// [Pa]. Reads reference_position and volume.
template <int Dim>
std::uint64_t elastic_correction(const ParticleView<Dim>& solid, const NeighborList& list, std::span<const double> stiffness,
                                 const PairMethod<Dim>& method, SymTensorField<Dim>& gradient_correction,
                                 ScalarField& hourglass_stiffness);

/// deformation = F (a) and corrected_stress = T (c) for listed particles. Reads position, gradient_correction,
/// hourglass_stiffness and, if there is one, elastic_share, by which ψ and so P are multiplied.
template <int Dim>
std::uint64_t elastic_deformation(const ParticleView<Dim>& solid, const NeighborList& list,
                                  std::span<const Hyperelastic> laws, const PairMethod<Dim>& method, TupleField<Dim * Dim>& deformation,
                                  TupleField<Dim * Dim>& corrected_stress);

/// acceleration += f/m (c), and of the viscosity, if there is any (ReferenceViscosity). Reads position,
/// corrected_stress, hourglass_stiffness and, for viscosity, velocity.
template <int Dim>
std::uint64_t elastic_momentum(const ParticleView<Dim>& solid, const NeighborList& list,
                               const ElasticViscosity& viscosity, const PairMethod<Dim>& method,
                               VectorField<Dim>& acceleration);

/// energy = a particle's share of the second sum of (b) [J; J/m in 2D], for listed particles. For output: the forces
/// do not need it. Reads position, deformation and hourglass_stiffness.
template <int Dim>
std::uint64_t hourglass_energy(const ParticleView<Dim>& solid, const NeighborList& list, const PairMethod<Dim>& method,
                               ScalarField& energy);

}  // namespace sluice
