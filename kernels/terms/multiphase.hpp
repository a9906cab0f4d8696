// Terms for pairs of particles of different fluids, or of different solids that are joined.
//
// Where the density jumps, m_j stands for the wrong volume: with p/ρ² and Σ m_j v_ij·∇W a light particle beside a heavy
// one is pushed, and diluted, as if the jump were compression. Written with volumes V_j = m_j/ρ_j both sums see
// pressure and velocity alone, which are continuous there [Colagrossi & Landrini 2003; Hu & Adams 2006]. In a medium of
// one material they differ from the others by what its compression is, below 1 %.
#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Pressure part of the momentum equation; equal and opposite within a pair.
///   a_i = −Σ_j m_j (p_i + p_j)/(ρ_i ρ_j) ∇_i W_ij          [m/s²]
struct VolumePressure {
    static constexpr ColumnSet reads_i = column::pressure | column::density,
                               reads_j = column::mass | column::pressure | column::density;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        return -(ij.p_i() + ij.p_j()) * reciprocal(ij.rho_i() * ij.rho_j());
    }
};

/// Stress part of a hypoelastic solid's momentum equation, from σ/ρ²; equal and opposite within a pair.
///   a_i = Σ_j m_j (σ_i + σ_j)/(ρ_i ρ_j) ∇_i W_ij          [m/s²]
struct VolumeStress {
    static constexpr ColumnSet reads_i = column::stress_over_rho2 | column::density,
                               reads_j = column::mass | column::stress_over_rho2 | column::density;

    template <class Pair>
    [[gnu::always_inline]] auto operator()(const Pair& ij) const {
        const auto ratio = ij.rho_i() * reciprocal(ij.rho_j()), inverse = ij.rho_j() * reciprocal(ij.rho_i());
        return ratio * ij.i(column::stress_over_rho2) + inverse * ij.j(column::stress_over_rho2);
    }
};

/// Continuity by volumes; zero for a uniform velocity.
///   dρ_i/dt = ρ_i Σ_j V_j v_ij·∇_i W_ij          [kg/m³/s]
struct VolumeContinuity {
    static constexpr ColumnSet reads_i = column::velocity | column::density,
                               reads_j = column::mass | column::velocity | column::density;

    template <class Pair>
    [[gnu::always_inline]] auto operator()(const Pair& ij) const {
        return (ij.rho_i() * reciprocal(ij.rho_j())) * ij.m_grad_w_over_x() * dot(ij.v_ij(), ij.x_ij);
    }
};

/// CentralViscosity with the mean of both sound speeds: α (c_i + c_j)/2 in place of α c.
struct MultiphaseViscosity {
    static constexpr ColumnSet reads_i = column::velocity | column::density | column::sound_speed,
                               reads_j = column::mass | column::velocity | column::density | column::sound_speed;

    double alpha = 0;      ///< α
    double constant = 0;   ///< κ [m²/s]
    double limit = 0;      ///< L: 0 for approaching pairs only
    double softening = 0;  ///< ε

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real limited = smaller(dot(ij.v_ij(), ij.x_ij), Real(limit));
        const Real twice_c = ij.i(column::sound_speed) + ij.j(column::sound_speed);
        const Real denominator = (ij.r2 + Real(softening) * ij.h * ij.h) * (ij.rho_i() + ij.rho_j());
        return (Real(alpha) * twice_c * ij.h + Real(2 * constant)) * limited * reciprocal(denominator);
    }
};

/// Density diffusion within each fluid (density_diffusion.hpp) of what a column holds of its density beyond that at
/// rest; nothing is exchanged between different fluids, whose difference is no noise.
///   dρ_i/dt += δ Σ_j c_i h_ij V_j 2 (e_i − e_j) ∇_i W_ij/x,   j of i's own fluid
struct MultiphaseDiffusion {
    static constexpr ColumnSet reads_i = column::excess_density | column::rest_density | column::sound_speed,
                               reads_j = column::mass | column::density | column::excess_density |
                                         column::rest_density | column::sound_speed;

    double coefficient = 0;  ///< δ

    /// Over m_j ∇W/x.
    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real rho = Real(1e15) * (ij.i(column::rest_density) - ij.j(column::rest_density)),
                   c = Real(1e15) * (ij.i(column::sound_speed) - ij.j(column::sound_speed));
        const Real alike = larger(Real(1) - (rho * rho + c * c), Real(0));  // 1 or 0
        const Real excess = ij.i(column::excess_density) - ij.j(column::excess_density);
        return alike * (Real(2 * coefficient) * ij.i(column::sound_speed) * ij.h) * reciprocal(ij.rho_j()) * excess;
    }
};

/// ReferenceViscosity with the mean of both impedances, η = α (ρ0 c0)_ij.
struct MultiphaseReferenceViscosity {
    static constexpr ColumnSet reads_i =
                                   column::velocity | column::position | column::rest_density | column::sound_speed,
                               reads_j = reads_i;

    double alpha = 0;  ///< α

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const auto x_ij = ij.current_x_ij();
        const Real approach = smaller(dot(ij.v_ij(), x_ij), Real(0));
        const Real distance2 = dot(x_ij, x_ij) + Real(0.01) * ij.h * ij.h;
        const Real impedances = ij.i(column::rest_density) * ij.i(column::sound_speed) +
                                ij.j(column::rest_density) * ij.j(column::sound_speed);
        return (Real(0.5 * alpha) * impedances * ij.h) * approach * reciprocal(distance2);
    }
};

}  // namespace sluice
