// The tensor R of the artificial stress, particle by particle [Antoci2007, eq. 14; Gray, Monaghan & Swift 2001].
#pragma once

#include "kernels/principal.hpp"
#include "kernels/tensor.hpp"

namespace sluice {

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
    const auto [values, axes] = principal<3>(sym_to_tensor<3>(stress_over_rho2));
    if (values[2] <= 0) return {};
    const Eigen::Vector3d corrected = -e * values.cwiseMax(0.0);
    const Tensor<3> r = axes * corrected.asDiagonal() * axes.transpose();
    return tensor_to_sym<3>(r);
}

}  // namespace sluice
