// Artificial stress against the tensile instability [Antoci2007, eqs. 13, 14; Gray, Monaghan & Swift 2001].
#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Repulsion between neighbours where the material is in tension; equal and opposite within a pair.
///   a_i = Σ_j m_j (R_i + R_j) f^q ∇_i W_ij,   f = W(|x_ij|)/W(d)          [m/s²]
/// W(d) is taken at the pair's own spacing, d = h/(h/d): f depends on r/h and h/d only.
struct ArtificialStress {
    static constexpr ColumnSet reads_i = column::artificial_stress, reads_j = column::mass | column::artificial_stress;

    double inverse_shape_at_spacing = 0;  ///< 1/w(d/h)
    int exponent = 4;                     ///< q

    template <int Dim>
    static ArtificialStress with(const Smoothing<Dim>& smoothing, double h_over_d, int exponent) {
        return {1 / smoothing.shape(1 / h_over_d), exponent};
    }

    /// f^q for q = 1 … 15 by squaring, without a loop: the exponent's bits are the same for all pairs.
    template <class Real>
    [[gnu::always_inline]] Real power(Real f) const {
        const Real f2 = f * f, f4 = f2 * f2;
        if (exponent == 4) return f4;  // the paper's
        const Real f8 = f4 * f4;
        return (exponent & 1 ? f : Real(1)) * (exponent & 2 ? f2 : Real(1)) * (exponent & 4 ? f4 : Real(1)) *
               (exponent & 8 ? f8 : Real(1));
    }

    template <class Pair>
    [[gnu::always_inline]] auto operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real f = ij.shape() * static_cast<Real>(inverse_shape_at_spacing);
        return power(f) * (ij.i(column::artificial_stress) + ij.j(column::artificial_stress));
    }
};

}  // namespace sluice
