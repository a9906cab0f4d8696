// Smoothing functions W(r, h) = σ/h^Dim · w(q), q = r/h.
#pragma once

#include <numbers>

#include "neighbor/vec.hpp"

namespace sluice {

/// Cubic spline, support 2h [Antoci2007, eq. 9; Monaghan 1992].
///   w(q) = 1 − 3/2 q² + 3/4 q³ (q < 1),  1/4 (2 − q)³ (1 ≤ q < 2),  0 beyond
/// Written with truncated powers, w = (2−q)₊³/4 − (1−q)₊³, the same polynomial without a branch.
template <int Dim>
struct CubicSpline {
    static constexpr double support = 2;  ///< in units of h
    static constexpr double sigma = Dim == 2 ? 10 / (7 * std::numbers::pi) : 1 / std::numbers::pi;

    /// w(q)
    template <class Real>
    static constexpr Real shape(Real q) {
        const Real outer = larger(Real(2) - q, Real(0)), inner = larger(Real(1) - q, Real(0));
        return Real(0.25) * outer * outer * outer - inner * inner * inner;
    }
    /// dw/dq
    template <class Real>
    static constexpr Real slope(Real q) {
        const Real outer = larger(Real(2) - q, Real(0)), inner = larger(Real(1) - q, Real(0));
        return Real(-0.75) * outer * outer + Real(3) * inner * inner;
    }
};

/// σ/h^Dim from 1/h.
template <class Smoothing, int Dim, class Real>
constexpr Real kernel_scale(Real inverse_h) {
    Real s = static_cast<Real>(Smoothing::sigma);
    unroll<Dim>([&](int) { s *= inverse_h; });
    return s;
}

}  // namespace sluice
