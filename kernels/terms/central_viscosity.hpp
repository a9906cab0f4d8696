#pragma once

#include <limits>

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Viscous force along the line between two particles: keeps momentum and angular momentum, and is zero in a medium
/// that turns as a rigid body.
///   a_i = Σ_j m_j (α c h + κ) min(v_ij·x_ij, L) / (ρ̄_ij (|x_ij|² + ε h²)) ∇_i W_ij          [m/s²]
/// Artificial viscosity has α c, L = 0 and ε = 0.01 (artificial_viscosity.hpp), Monaghan & Gingold's laminar one κ
/// (laminar_viscosity.hpp). One formula for both costs what either does; a branch between them in the loop cost 5 to
/// 15 % (bench: fluid_momentum).
struct CentralViscosity {
    static constexpr ColumnSet reads_i = column::velocity | column::density,
                              reads_j = column::mass | column::velocity | column::density;

    double per_length = 0;                                   ///< α c [m/s]
    double constant = 0;                                     ///< κ [m²/s]
    double limit = std::numeric_limits<double>::infinity();  ///< L: 0 for approaching pairs only
    double softening = 0;                                    ///< ε

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real limited = smaller(dot(ij.v_ij(), ij.x_ij), Real(limit));
        // One division; ρ̄ is half the sum.
        const Real denominator = (ij.r2 + Real(softening) * ij.h * ij.h) * (ij.rho_i() + ij.rho_j());
        return (Real(2 * per_length) * ij.h + Real(2 * constant)) * limited * reciprocal(denominator);
    }
};

}  // namespace sluice
