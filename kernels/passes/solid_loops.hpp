// The solid's passes over pairs, as sets of terms.
#pragma once

#include "kernels/pairs/momentum_terms.hpp"
#include "kernels/terms/artificial_stress.hpp"
#include "kernels/terms/artificial_viscosity.hpp"
#include "kernels/terms/symmetric_stress.hpp"

namespace sluice {

/// The stress with those of the other two that a scene calls for.
template <int Dim, class... More>
using StressDivergence = MomentumTerms<Dim, SymmetricStress, More...>;
template <int Dim, class... More>
inline constexpr std::string_view pass_name<MomentumTerms<Dim, SymmetricStress, More...>> = "solid momentum";

/// dρ_i/dt of eq. (8), then G = Σ_j V_j (v_j − v_i) ⊗ ∇W and M = Σ_j V_j (x_j − x_i) ⊗ ∇W of eq. (15), row by row.
template <int Dim>
struct SolidRateSums {
    static constexpr std::string_view name = "velocity gradient";
    static constexpr int dim = Dim, outputs = 1 + 2 * Dim * Dim;
    static constexpr int G = 1, M = 1 + Dim * Dim;  ///< where they begin
    static constexpr ColumnSet reads_i = column::velocity, reads_j = reads_i | column::mass | column::density;

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const auto v_ij = ij.v_ij();
        const Real slope = ij.m_grad_w_over_x();
        const auto v_grad_w = (slope / ij.rho_j()) * ij.x_ij;
        Vec<outputs, Real> out;
        out[0] = slope * dot(v_ij, ij.x_ij);
        unroll<Dim * Dim>([&](int k) __attribute__((always_inline)) {
            out[G + k] = -(v_ij[k / Dim] * v_grad_w[k % Dim]);
            out[M + k] = -(ij.x_ij[k / Dim] * v_grad_w[k % Dim]);
        });
        return out;
    }
};

}  // namespace sluice
