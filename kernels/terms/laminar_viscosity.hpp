// The viscous force ν ∇²v of a Newtonian fluid, in two forms.
//
// The papers divide by |x_ij|² + η², η² = 0.01 h². It is left out: ∇W/x is finite at x = 0, so nothing needs softening,
// and η takes its share of the viscosity however many neighbours there are: 1 to 2 %, by smoothing function.
#pragma once

#include "kernels/terms/central_viscosity.hpp"

namespace sluice {

/// Along the difference of velocities [Morris, Fox & Zhu 1997, eq. 22]; keeps momentum, but angular momentum only as
/// far as the neighbours stand evenly.
///   a_i = Σ_j m_j (μ_i + μ_j)/(ρ_i ρ_j) (x_ij·∇_i W_ij)/|x_ij|² v_ij,   μ = ρ ν          [m/s²]
/// Let v_j be given to second order in y = x_j − x_i. Its first order cancels, and Σ_j V_j y_k y_l (∇W/x) → −δ_kl for
/// any W in any dimension: the sum tends to 2ν ½ ∇²v, without a factor of its own.
struct MorrisViscosity {
    static constexpr ColumnSet reads_i = column::velocity | column::density,
                              reads_j = column::mass | column::velocity | column::density;

    double kinematic_viscosity = 0;  ///< ν [m²/s]

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real inverse_densities = (ij.rho_i() + ij.rho_j()) * reciprocal(ij.rho_i() * ij.rho_j());
        return (Real(kinematic_viscosity) * inverse_densities * ij.m_grad_w_over_x()) * ij.v_ij();
    }
};

/// Along the line between two particles [Monaghan & Gingold 1983; Monaghan 2005, sec. 8.2].
///   a_i = Σ_j m_j 2(D + 2) ν v_ij·x_ij/(ρ̄_ij |x_ij|²) ∇_i W_ij          [m/s²]
/// D is the dimension. To second order in y = r n the sum is −(D + 2) ν ∂_l ∂_m v_p Σ_j V_j r² (∇W/x) n_k n_l n_m n_p.
/// Σ_j V_j r² (∇W/x) → −D, and the mean of n_k n_l n_m n_p over all directions is (δ_kl δ_mp + δ_km δ_lp + δ_kp
/// δ_lm)/(D(D + 2)). That leaves ν (∇²v + 2 ∇(∇·v)): with the factor 8 in 2D and 10 in 3D the viscosity ν, and beside
/// it a bulk viscosity, 2 ρν in 2D and 5/3 ρν in 3D, that an incompressible flow does not feel.
template <int Dim>
CentralViscosity monaghan_gingold_viscosity(double kinematic_viscosity) {
    CentralViscosity viscosity;
    viscosity.constant = 2 * (Dim + 2) * kinematic_viscosity;
    return viscosity;
}

}  // namespace sluice
