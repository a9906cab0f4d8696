#pragma once

#include "kernels/pair.hpp"

namespace sluice {

/// Artificial viscosity [Antoci2007, eq. 12; Monaghan & Gingold 1983]; acts on approaching pairs only.
///   a_i = −Σ_j m_j Π_ij ∇_i W_ij,   Π_ij = −α c μ_ij / ρ̄_ij if v_ij·x_ij < 0, else 0          [m/s²]
///   μ_ij = h v_ij·x_ij / (|x_ij|² + (0.1 h)²)
/// Both partners are of one medium, so the mean sound speed c̄ is that medium's c0.
struct ArtificialViscosity {
    static constexpr unsigned reads_i = column::velocity | column::density,
                              reads_j = column::mass | column::velocity | column::density;

    double alpha = 0;        ///< α
    double sound_speed = 0;  ///< c [m/s]

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real approach = smaller(dot(ij.v_ij(), ij.x_ij), Real(0));
        // With one division: −Π = α c h v·x / ((r² + (0.1 h)²) ρ̄)
        const Real denominator = (ij.r2 + Real(0.01) * ij.h * ij.h) * (ij.rho_i() + ij.rho_j());
        return (Real(2 * alpha * sound_speed) * ij.h) * approach * reciprocal(denominator);
    }
};

}  // namespace sluice
