// Artificial stress against the tensile instability [Antoci2007, eqs. 13, 14; Gray, Monaghan & Swift 2001].
#pragma once

#include <Eigen/Eigenvalues>

#include "kernels/tensor.hpp"
#include "kernels/tile.hpp"

namespace sluice {

/// Repulsion between neighbours where the material is in tension; equal and opposite within a pair.
///   a_i = Σ_j m_j (R_i + R_j) f^q ∇_i W_ij,   f = W(|x_ij|)/W(d)          [m/s²]
/// W(d) is taken at the pair's own spacing, d = h/(h/d): f depends on r/h and h/d only.
struct ArtificialStress {
    static constexpr unsigned reads_i = column::artificial_stress, reads_j = column::mass | column::artificial_stress;

    double inverse_shape_at_spacing = 0;  ///< 1/w(d/h)
    int exponent = 4;                     ///< q

    template <class Smoothing>
    static ArtificialStress with(double h_over_d, int exponent) {
        return {1 / Smoothing::shape(1 / h_over_d), exponent};
    }

    /// f^q for q = 1 … 15 by squaring, without a loop: the exponent's bits are the same for all pairs.
    template <class Real>
    Real power(Real f) const {
        const Real f2 = f * f, f4 = f2 * f2, f8 = f4 * f4;
        return (exponent & 1 ? f : Real(1)) * (exponent & 2 ? f2 : Real(1)) * (exponent & 4 ? f4 : Real(1)) *
               (exponent & 8 ? f8 : Real(1));
    }

    template <class Pair>
    typename Pair::Vector operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real f = ij.shape() * static_cast<Real>(inverse_shape_at_spacing);
        return (ij.m_j() * power(f)) * sym_times(ij.artificial_stress_i() + ij.artificial_stress_j(), ij.grad_w());
    }
};

/// R = Σ_k −e σ̄_k/ρ² n_k⊗n_k over the tensile principal stresses σ̄_k > 0 with directions n_k.  (14)
///
/// In 2D no angle is needed. With m = (σ_xx + σ_yy)/2 and ϱ = sqrt(((σ_xx − σ_yy)/2)² + σ_xy²) the principal values are
/// m ± ϱ, and any function f of the tensor is f(σ) = ½(f₊ + f₋) I + ½(f₊ − f₋)/ϱ (σ − m I), f± = f(m ± ϱ).
inline Vec<3> tensile_correction(const Vec<3>& stress_over_rho2, double e) {
    const auto& s = stress_over_rho2;
    const double mean = 0.5 * (s[0] + s[1]), half_difference = 0.5 * (s[0] - s[1]);
    const double radius = std::sqrt(half_difference * half_difference + s[2] * s[2]);
    if (mean + radius <= 0) return {};
    const double f_plus = -e * (mean + radius), f_minus = -e * std::max(mean - radius, 0.0);
    const double isotropic = 0.5 * (f_plus + f_minus);
    const double deviatoric = radius > 0 ? 0.5 * (f_plus - f_minus) / radius : 0.0;
    return {{isotropic + deviatoric * half_difference, isotropic - deviatoric * half_difference, deviatoric * s[2]}};
}

inline Vec<6> tensile_correction(const Vec<6>& stress_over_rho2, double e) {
    const Eigen::SelfAdjointEigenSolver<Tensor<3>> principal(sym_to_tensor<3>(stress_over_rho2));
    if (principal.eigenvalues()[2] <= 0) return {};
    const Eigen::Vector3d corrected = -e * principal.eigenvalues().cwiseMax(0.0);
    const Tensor<3> r = principal.eigenvectors() * corrected.asDiagonal() * principal.eigenvectors().transpose();
    return tensor_to_sym<3>(r);
}

}  // namespace sluice
