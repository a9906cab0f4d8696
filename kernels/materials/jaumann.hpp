// Hypoelastic stress with the Jaumann rate, advanced implicitly.
//
// Signs. With L_ij = ∂v_i/∂x_j, D = (L + Lᵀ)/2 and Ω = (L − Lᵀ)/2 (eqs. 6, 7), a body that spins without deforming has
// v = Ω x, and its stress must turn with it: S(t) = Q S(0) Qᵀ with dQ/dt = Ω Q, hence dS/dt = Ω S + S Ωᵀ. That is the
// corotational part of eq. (5) as written in the paper, S_ik Ω_jk + Ω_ik S_kj, now with its sign proved:
//   dS/dt = 2μ (D − tr(D)/3 I) + Ω S + S Ωᵀ                                                              (5)
//
// Implicit update. The midpoint rule for dQ/dt = Ω Q over a step, (I − Δt/2 Ω) Q = (I + Δt/2 Ω), gives a Q that is
// exactly orthogonal for every Δt [Hughes & Winget 1980]: rotation alone changes neither the principal stresses nor the
// energy, however large the step. An explicit update would grow S by (1 + (2ωΔt)²)^½ each step.
//   S(n+1) = Q S(n) Qᵀ + 2μ Δt (D − tr(D)/3 I)
// In 2D the strain is plane: D_zz = 0 but S_zz ≠ 0. S is traceless, so S_zz = −S_xx − S_yy need not be stored.
#pragma once

#include "kernels/tensor.hpp"

namespace sluice {

/// The rotation over one step: Q = (I − Δt/2 Ω)⁻¹ (I + Δt/2 Ω).
template <int Dim>
Tensor<Dim> step_rotation(const Tensor<Dim>& velocity_gradient, double dt) {
    const Tensor<Dim> half = 0.25 * dt * (velocity_gradient - velocity_gradient.transpose());
    const Tensor<Dim> identity = Tensor<Dim>::Identity();
    return (identity - half).inverse() * (identity + half);
}

/// S after one step of the given velocity gradient dv_i/dx_j [1/s].
template <int Dim>
Tensor<Dim> advance_deviatoric_stress(const Tensor<Dim>& stress, const Tensor<Dim>& velocity_gradient,
                                      double shear_modulus, double dt) {
    const Tensor<Dim> q = step_rotation<Dim>(velocity_gradient, dt);
    const Tensor<Dim> rate = 0.5 * (velocity_gradient + velocity_gradient.transpose());
    const Tensor<Dim> deviator = rate - rate.trace() / 3 * Tensor<Dim>::Identity();
    return q * stress * q.transpose() + 2 * shear_modulus * dt * deviator;
}

/// S:S with the out-of-plane component of plane strain included in 2D.
template <int Dim>
double contract_deviator(const Tensor<Dim>& s) {
    const double out_of_plane = Dim == 2 ? s.trace() * s.trace() : 0.0;
    return s.squaredNorm() + out_of_plane;
}

}  // namespace sluice
