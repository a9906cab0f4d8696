// Smoothing functions W(r, h) = σ/h^Dim · w(q), q = r/h.
#pragma once

#include <numbers>

#include "neighbor/vec.hpp"

namespace sluice {

/// Cubic spline, support 2h [Antoci2007, eq. 9; Monaghan 1992].
///   w(q) = 1 − 3/2 q² + 3/4 q³ (q < 1),  1/4 (2 − q)³ (1 ≤ q < 2),  0 beyond
/// Written with truncated powers, w = 2 (1 − q/2)₊³ − (1 − q)₊³, the same polynomial without a branch.
template <int Dim>
struct CubicSpline {
    static constexpr double support = 2;  ///< in units of h
    static constexpr double sigma = Dim == 2 ? 10 / (7 * std::numbers::pi) : 1 / std::numbers::pi;

    /// w(q)
    template <class Real>
    [[gnu::always_inline]] static constexpr Real shape(Real q) {
        const Real outer = larger(Real(1) - Real(0.5) * q, Real(0)), inner = larger(Real(1) - q, Real(0));
        return Real(2) * outer * outer * outer - inner * inner * inner;
    }
    /// dw/dq = slope_scale · reduced_slope(q): the constant is multiplied in once per loop, not once per pair.
    static constexpr double slope_scale = 3;
    template <class Real>
    [[gnu::always_inline]] static constexpr Real reduced_slope(Real q) {
        const Real outer = larger(Real(1) - Real(0.5) * q, Real(0)), inner = larger(Real(1) - q, Real(0));
        return inner * inner - outer * outer;
    }
    template <class Real>
    [[gnu::always_inline]] static constexpr Real slope(Real q) {
        return Real(slope_scale) * reduced_slope(q);
    }
};

/// Which smoothing function the passes use.
template <int Dim>
using DefaultSmoothing = CubicSpline<Dim>;

/// σ/h^Dim from 1/h.
template <class Smoothing, int Dim, class Real>
[[gnu::always_inline]] constexpr Real kernel_scale(Real inverse_h) {
    Real s = static_cast<Real>(Smoothing::sigma);
    unroll<Dim>([&](int) __attribute__((always_inline)) { s *= inverse_h; });
    return s;
}

}  // namespace sluice
