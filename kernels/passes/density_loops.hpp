// The passes of the fluid's density diffusion, as sets of terms.
#pragma once

#include <string_view>

#include "kernels/pairs/pair.hpp"
#include "kernels/terms/continuity.hpp"
#include "kernels/terms/density_diffusion.hpp"

namespace sluice {

/// Continuity with diffusion in one loop.
template <int Dim, class Diffusion>
struct DiffusiveDensityRate {
    static constexpr std::string_view name = "fluid continuity";
    static constexpr int dim = Dim, outputs = 1;
    static constexpr ColumnSet reads_i = Continuity::reads_i | Diffusion::reads_i;
    static constexpr ColumnSet reads_j = Continuity::reads_j | Diffusion::reads_j;

    Diffusion diffusion;

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& ij) const {
        return {{ij.m_grad_w_over_x() * (dot(ij.v_ij(), ij.x_ij) + diffusion(ij))}};
    }
};

/// Σ_j V_j (ρ_j − ρ_i) ∇W, then the symmetric M = Σ_j V_j (x_j − x_i) ⊗ ∇W.
template <int Dim>
struct DensityGradientSums {
    static constexpr std::string_view name = "density gradient";
    static constexpr int dim = Dim, outputs = Dim + sym_components<Dim>;
    static constexpr ColumnSet reads_i = column::density, reads_j = column::mass | column::density;

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        // The product of components a and b of M in the order of a packed tensor (kernels/tensor.hpp).
        constexpr int a[] = {0, 1, Dim == 2 ? 0 : 2, 0, 0, 1}, b[] = {0, 1, Dim == 2 ? 1 : 2, 1, 2, 2};
        const auto v_grad_w = (ij.m_grad_w_over_x() * reciprocal(ij.rho_j())) * ij.x_ij;
        const Real difference = ij.rho_j() - ij.rho_i();
        Vec<outputs, Real> out;
        unroll<Dim>([&](int k) __attribute__((always_inline)) { out[k] = difference * v_grad_w[k]; });
        unroll<sym_components<Dim>>([&](int k) __attribute__((always_inline)) {
            out[Dim + k] = -(ij.x_ij[a[k]] * v_grad_w[b[k]]);
        });
        return out;
    }
};

}  // namespace sluice
