// Diffusion of the density, against the noise that the continuity equation leaves in a weakly compressible fluid's
// pressure.
//   dρ_i/dt += δ c0 Σ_j h_ij V_j Ψ_ij·∇_i W_ij,   Ψ_ij = 2 (ρ_j − ρ_i − E_ij) x_ji/|x_ij|²          [kg/m³/s]
// V_j = m_j/ρ_j; x_ji = x_j − x_i, so that Ψ·∇W = 2 (ρ_i + E_ij − ρ_j) ∇W/x: density flows from where there is more of
// it. In a full support the sum tends to δ h c0 ∇²ρ. E_ij is the difference that is no noise, E_ij = −E_ji:
//   0                                      [Molteni & Colagrossi 2009]
//   ρ0 g·(x_j − x_i)/c0²                   the fluid's at rest [Fourtakas et al. 2019]
//   ½ (⟨∇ρ⟩_i + ⟨∇ρ⟩_j)·(x_j − x_i)        with gradients exact for linear fields [Antuono et al. 2010]
// Without it a stratified fluid is diffused where its support ends, at walls and surfaces.
//
// Fourtakas et al. take E from Tait's equation, ρ0 ((1 + γ p/(ρ0 c0²))^(1/γ) − 1) with p = ρ0 g·(x_j − x_i). That
// differs from the linear one by (γ − 1)/2 p/(ρ0 c0²) of itself: for γ = 7, neighbours 2h apart and c0² = 100 g H with
// the depth H, by 0.06 h/H. Either is the slope at the surface; at the depth H it is (ρ/ρ0)^(2 − γ) times that, 5 %
// less with γ = 7 and 1 % more with γ = 1. So the linear one is enough.
//
// In each pair V_i V_j Ψ_ij·∇_i W_ij = −V_j V_i Ψ_ji·∇_j W_ji, whatever the masses: diffusion keeps Σ_i V_i dρ_i/dt =
// 0, that is Σ_i m_i ln ρ_i.
#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Diffusion with E_ij = G·(x_j − x_i) of a uniform gradient G, zero or that of the fluid at rest.
template <int Dim>
struct StratifiedDiffusion {
    static constexpr ColumnSet reads_i = column::density, reads_j = column::mass | column::density;

    double strength = 0;  ///< δ c0 [m/s]
    Vec<Dim> gradient;    ///< G [kg/m⁴]

    /// Over m_j ∇W/x.
    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        Real excess = ij.rho_i() - ij.rho_j();
        unroll<Dim>([&](int k) __attribute__((always_inline)) { excess -= Real(gradient[k]) * ij.x_ij[k]; });
        return ((Real(2 * strength) * ij.h) * reciprocal(ij.rho_j())) * excess;
    }
};

/// Diffusion with E_ij of the mean of both particles' own gradients.
struct GradientDiffusion {
    static constexpr ColumnSet reads_i = column::density | column::density_gradient,
                              reads_j = column::mass | column::density | column::density_gradient;

    double strength = 0;  ///< δ c0 [m/s]

    /// Over m_j ∇W/x.
    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real expected = Real(0.5) * dot(ij.i(column::density_gradient) + ij.j(column::density_gradient), ij.x_ij);
        return ((Real(2 * strength) * ij.h) * reciprocal(ij.rho_j())) * (ij.rho_i() - ij.rho_j() - expected);
    }
};

}  // namespace sluice
