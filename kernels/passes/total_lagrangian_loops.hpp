// The passes of an elastic solid in its reference configuration, as sets of terms. Places and ∇W are of the reference
// configuration: X_ij is `ij.x_ij`, and w_ij stands for −W'(|X_ij|)/|X_ij| ≥ 0, so that ∇_i W_ij = −w_ij X_ij.
//
// All are double in every precision: F − I is the strain, and strains of 10⁻⁶ drown in a float's 10⁻⁷.
#pragma once

#include <string_view>

#include "kernels/pairs/pair.hpp"
#include "kernels/terms/reference_viscosity.hpp"

namespace sluice {

/// M = Σ_j V_j (X_j − X_i) ⊗ ∇_i W_ij = Σ_j V_j w_ij X_ij ⊗ X_ij, which is symmetric.
template <int Dim>
struct GradientMatrixSums {
    static constexpr std::string_view name = "gradient correction";
    static constexpr auto place = column::reference_position;
    static constexpr int dim = Dim, outputs = sym_components<Dim>;
    static constexpr bool always_full = true;
    static constexpr ColumnSet reads_i = {}, reads_j = column::volume;

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ij) const {
        const auto& x = ij.x_ij;
        const auto w_x = -(ij.volume_j() * ij.grad_w_over_x()) * x;
        if constexpr (Dim == 2)
            return {{w_x[0] * x[0], w_x[1] * x[1], w_x[0] * x[1]}};
        else
            return {{w_x[0] * x[0], w_x[1] * x[1], w_x[2] * x[2], w_x[0] * x[1], w_x[0] * x[2], w_x[1] * x[2]}};
    }
};

/// Σ_j V_j (x_j − x_i) ⊗ ∇_i W_ij, row by row: F before it is corrected.
template <int Dim>
struct DeformationSums {
    static constexpr std::string_view name = "deformation gradient";
    static constexpr auto place = column::reference_position;
    static constexpr int dim = Dim, outputs = Dim * Dim;
    static constexpr bool always_full = true;
    static constexpr ColumnSet reads_i = column::position, reads_j = reads_i | column::volume;

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ij) const {
        const auto w_x = -(ij.volume_j() * ij.grad_w_over_x()) * ij.x_ij;
        const auto current = ij.current_x_ij();
        Vec<outputs, typename Pair::Real> out;
        unroll<outputs>([&](int k) __attribute__((always_inline)) { out[k] = current[k / Dim] * w_x[k % Dim]; });
        return out;
    }
};

/// Σ_j V_j W'/|X_ij| {(T_i + T_j) X_ij + (k_i + k_j + viscosity) x_ij} with T = P L − k F: force per volume, stress and
/// hourglass control in one. A scene without viscosity has no `Viscosity`.
template <int Dim, class... Viscosity>
struct ElasticMomentum : Viscosity... {
    static constexpr std::string_view name = "elastic momentum";
    static constexpr auto place = column::reference_position;
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
    static constexpr ColumnSet of_elasticity =
        column::position | column::corrected_stress | column::hourglass_stiffness;
    static constexpr ColumnSet reads_i = (of_elasticity | ... | Viscosity::reads_i);
    static constexpr ColumnSet reads_j = reads_i | column::volume;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const auto stress = full_times<Dim>(ij.i(column::corrected_stress) + ij.j(column::corrected_stress), ij.x_ij);
        Real stiffness = ij.i(column::hourglass_stiffness) + ij.j(column::hourglass_stiffness);
        (..., (stiffness += Viscosity::operator()(ij)));
        return (ij.volume_j() * ij.grad_w_over_x()) * (stress + stiffness * ij.current_x_ij());
    }
};

/// Σ_j V_j w_ij |x_ij − F_i X_ij|²
template <int Dim>
struct HourglassErrors {
    static constexpr std::string_view name = "hourglass energy";
    static constexpr auto place = column::reference_position;
    static constexpr int dim = Dim, outputs = 1;
    static constexpr bool always_full = true;
    static constexpr ColumnSet reads_i = column::position | column::deformation;
    static constexpr ColumnSet reads_j = column::position | column::volume;

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& ij) const {
        const auto error = ij.current_x_ij() - full_times<Dim>(ij.i(column::deformation), ij.x_ij);
        return {{-(ij.volume_j() * ij.grad_w_over_x()) * dot(error, error)}};
    }
};

}  // namespace sluice
