// Smoothing functions W(r, h) = σ/h^Dim · w(q), q = r/h, and the choice among them at run time.
//
// Each is written with truncated powers of u = 1 − q/κ, κ its support over h: polynomials that are zero beyond the
// support without a branch.
#pragma once

#include <numbers>

#include "kernels/choices.hpp"
#include "neighbor/vec.hpp"

namespace sluice {

/// Cubic spline, support 2h [Antoci2007, eq. 9; Monaghan 1992].
///   w(q) = 1 − 3/2 q² + 3/4 q³ (q < 1),  1/4 (2 − q)³ (1 ≤ q < 2),  0 beyond
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
};

/// Wendland C2, support 2h [Wendland 1995; Dehnen & Aly 2012]: its transform is positive, so particles do not pair.
///   w(q) = (1 − q/2)⁴ (1 + 2q)
template <int Dim>
struct WendlandC2 {
    static constexpr double support = 2;
    static constexpr double sigma = Dim == 2 ? 7 / (4 * std::numbers::pi) : 21 / (16 * std::numbers::pi);

    template <class Real>
    [[gnu::always_inline]] static constexpr Real shape(Real q) {
        const Real u = larger(Real(1) - Real(0.5) * q, Real(0)), u2 = u * u;
        return (u2 * u2) * (Real(1) + Real(2) * q);
    }
    /// dw/dq = −5 q (1 − q/2)³
    static constexpr double slope_scale = -5;
    template <class Real>
    [[gnu::always_inline]] static constexpr Real reduced_slope(Real q) {
        const Real u = larger(Real(1) - Real(0.5) * q, Real(0));
        return (u * u) * (u * q);
    }
};

/// Wendland C4, support 2h [Wendland 1995; Dehnen & Aly 2012].
///   w(q) = (1 − q/2)⁶ (1 + 3q + 35/12 q²)
template <int Dim>
struct WendlandC4 {
    static constexpr double support = 2;
    static constexpr double sigma = Dim == 2 ? 9 / (4 * std::numbers::pi) : 495 / (256 * std::numbers::pi);

    template <class Real>
    [[gnu::always_inline]] static constexpr Real shape(Real q) {
        const Real u = larger(Real(1) - Real(0.5) * q, Real(0)), u2 = u * u;
        const Real half_q = Real(1) - u;  // kept at 1 beyond the support: nothing overflows there
        return (u2 * u2 * u2) * (Real(1) + half_q * (Real(6) + Real(35.0 / 3) * half_q));
    }
    /// dw/dq = −14/3 q (1 + 5/2 q) (1 − q/2)⁵
    static constexpr double slope_scale = -14.0 / 3;
    template <class Real>
    [[gnu::always_inline]] static constexpr Real reduced_slope(Real q) {
        const Real u = larger(Real(1) - Real(0.5) * q, Real(0)), u2 = u * u;
        return (u2 * u2) * ((u * q) * (Real(1) + Real(2.5) * q));
    }
};

/// Quintic spline, support 3h [Schoenberg 1946; Morris, Fox & Zhu 1997].
///   w(q) = (3 − q)₊⁵ − 6 (2 − q)₊⁵ + 15 (1 − q)₊⁵
template <int Dim>
struct QuinticSpline {
    static constexpr double support = 3;
    static constexpr double sigma = Dim == 2 ? 7 / (478 * std::numbers::pi) : 1 / (120 * std::numbers::pi);

    template <class Real>
    [[gnu::always_inline]] static constexpr Real shape(Real q) {
        const Real a = larger(Real(3) - q, Real(0)), b = larger(Real(2) - q, Real(0)), c = larger(Real(1) - q, Real(0));
        const Real a2 = a * a, b2 = b * b, c2 = c * c;
        return a2 * a2 * a - Real(6) * (b2 * b2 * b) + Real(15) * (c2 * c2 * c);
    }
    static constexpr double slope_scale = -5;
    template <class Real>
    [[gnu::always_inline]] static constexpr Real reduced_slope(Real q) {
        const Real a = larger(Real(3) - q, Real(0)), b = larger(Real(2) - q, Real(0)), c = larger(Real(1) - q, Real(0));
        const Real a2 = a * a, b2 = b * b, c2 = c * c;
        return a2 * a2 - Real(6) * (b2 * b2) + Real(15) * (c2 * c2);
    }
};

/// The smoothing function of a run. All pairs of a loop take the same branch, which the processor foresees: a choice at
/// run time costs a loop some percent (bench: passes), and spares compiling every loop once per function.
template <int Dim>
struct Smoothing {
    SmoothingFunction function = SmoothingFunction::cubic_spline;
    double support = 2;      ///< in units of h
    double sigma = 0;        ///< W(0) h^Dim / w(0)
    double slope_scale = 0;  ///< dw/dq over reduced_slope

    Smoothing() : Smoothing(SmoothingFunction::cubic_spline) {}
    Smoothing(SmoothingFunction f) : function(f) {
        visit([this](auto w) {
            support = w.support;
            sigma = w.sigma;
            slope_scale = w.slope_scale;
        });
    }

    template <class Real>
    [[gnu::always_inline]] Real shape(Real q) const {
        return visit([q](auto w) __attribute__((always_inline)) { return w.shape(q); });
    }
    /// dw/dq = slope_scale · reduced_slope(q)
    template <class Real>
    [[gnu::always_inline]] Real reduced_slope(Real q) const {
        return visit([q](auto w) __attribute__((always_inline)) { return w.reduced_slope(q); });
    }
    /// σ/h^Dim from 1/h.
    template <class Real>
    [[gnu::always_inline]] Real scale(Real inverse_h) const {
        Real s = static_cast<Real>(sigma);
        unroll<Dim>([&](int) __attribute__((always_inline)) { s *= inverse_h; });
        return s;
    }
    /// W(r, h) [1/m^Dim]
    double operator()(double r, double h) const { return scale(1 / h) * shape(r / h); }

  private:
    template <class F>
    [[gnu::always_inline]] auto visit(F&& f) const {
        switch (function) {
            case SmoothingFunction::wendland_c2:
                return f(WendlandC2<Dim>{});
            case SmoothingFunction::wendland_c4:
                return f(WendlandC4<Dim>{});
            case SmoothingFunction::quintic_spline:
                return f(QuinticSpline<Dim>{});
            case SmoothingFunction::cubic_spline:
                break;
        }
        return f(CubicSpline<Dim>{});
    }
};

}  // namespace sluice
