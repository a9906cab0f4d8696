// The passes between interface elements and particles, as sets of terms. W stands for W(|x_k − x_b|, h_b) with the
// particle's own smoothing length.
#pragma once

#include <string_view>

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Σ_b 2 V_b p_b W_kb: (a) of kernels/passes/interface_passes.hpp.
template <int Dim>
struct ElementPressure {
    static constexpr std::string_view name = "element pressure";
    static constexpr int dim = Dim, outputs = 1;
    static constexpr bool always_full = true;
    static constexpr Length length = Length::of_j;
    static constexpr ColumnSet reads_i = {}, reads_j = column::mass | column::density | column::pressure;

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& kb) const {
        using Real = typename Pair::Real;
        return {{Real(2) * kb.m_j() / kb.rho_j() * kb.p_j() * kb.w()}};
    }
};

/// Σ_a V_a W_ka and Σ_a V_a W_ka v_a.
template <int Dim>
struct ElementWeights {
    static constexpr std::string_view name = "element weights";
    static constexpr int dim = Dim, outputs = 1 + Dim;
    static constexpr bool always_full = true;
    static constexpr Length length = Length::of_j;
    static constexpr ColumnSet reads_i = {}, reads_j = column::mass | column::density | column::velocity;

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ka) const {
        const auto v_w = ka.m_j() / ka.rho_j() * ka.w();
        const auto v_a = ka.v_j();
        Vec<outputs, typename Pair::Real> out;
        out[0] = v_w;
        unroll<Dim>([&](int k) __attribute__((always_inline)) { out[1 + k] = v_w * v_a[k]; });
        return out;
    }
};

/// Σ_k W_ka f_k/Σ_c V_c W_kc: (b), per volume of the particle.
template <int Dim>
struct ForceShare {
    static constexpr std::string_view name = "force on solid";
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
    static constexpr Length length = Length::of_i;
    static constexpr ColumnSet reads_i = {}, reads_j = column::shared_force;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ak) const {
        return ak.w() * ak.j(column::shared_force);
    }
};

/// Σ_k W_kb n_k ΔΓ_k of (c).
template <int Dim>
struct SurfaceIntegral {
    static constexpr std::string_view name = "force on fluid";
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
    static constexpr Length length = Length::of_i;
    static constexpr ColumnSet reads_i = {}, reads_j = column::area_normal;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& bk) const {
        return bk.w() * bk.j(column::area_normal);
    }
};

/// Σ_k W_kb n_k ΔΓ_k · (v_b − v_k) of (d).
template <int Dim>
struct SurfaceFlux {
    static constexpr std::string_view name = "continuity at elements";
    static constexpr int dim = Dim, outputs = 1;
    static constexpr bool always_full = true;
    static constexpr Length length = Length::of_i;
    static constexpr ColumnSet reads_i = column::velocity, reads_j = column::velocity | column::area_normal;

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& bk) const {
        return {{bk.w() * dot(bk.j(column::area_normal), bk.v_ij())}};
    }
};

}  // namespace sluice
