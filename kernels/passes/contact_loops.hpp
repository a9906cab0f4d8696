// The passes of contact between solids, as sets of terms. There are few such pairs: in double whatever is asked for,
// which spares compiling the other.
#pragma once

#include <string_view>

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// σ_i = Σ_j V_j W_ij and Σ_j V_j ∇_i W_ij
template <int Dim>
struct ContactSums {
    static constexpr std::string_view name = "contact density";
    static constexpr int dim = Dim, outputs = 1 + Dim;
    static constexpr bool always_full = true;
    static constexpr ColumnSet reads_i = {}, reads_j = column::volume;

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real slope = ij.volume_j() * ij.grad_w_over_x();
        Vec<outputs, Real> out;
        out[0] = (ij.volume_j() * ij.scale) * ij.shape();
        unroll<Dim>([&](int k) __attribute__((always_inline)) { out[1 + k] = slope * ij.x_ij[k]; });
        return out;
    }
};

/// −Σ_j V_j (p_i + p_j) ∇_i W_ij
template <int Dim>
struct ContactForce {
    static constexpr std::string_view name = "contact force";
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
    static constexpr ColumnSet reads_i = column::pressure, reads_j = column::pressure | column::volume;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ij) const {
        return (-(ij.volume_j() * (ij.p_i() + ij.p_j())) * ij.grad_w_over_x()) * ij.x_ij;
    }
};

}  // namespace sluice
