// The passes between fluid and fixed ghosts, as sets of terms.
#pragma once

#include <string_view>

#include "kernels/pairs/pair.hpp"
#include "kernels/terms/fixed_ghost.hpp"

namespace sluice {

template <int Dim>
struct GhostPressure : FixedGhostPressure {
    static constexpr std::string_view name = "ghost force";
    static constexpr int dim = Dim, outputs = Dim;
};

template <int Dim>
struct GhostContinuity : FixedGhostContinuity {
    static constexpr std::string_view name = "ghost continuity";
    static constexpr int dim = Dim, outputs = 1;

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& ij) const {
        return {{FixedGhostContinuity::operator()(ij)}};
    }
};

/// Σ_f V_f W_wf and Σ_f V_f (p_f + ρ_f g·(x_w − x_f)) W_wf of a ghost w.
template <int Dim>
struct GhostPressureSums {
    static constexpr std::string_view name = "ghost pressure";
    static constexpr int dim = Dim, outputs = 2;
    static constexpr ColumnSet reads_i = {}, reads_j = column::mass | column::density | column::pressure;

    Vec<Dim> gravity;  ///< [m/s²]

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real v_w = ij.m_j() * ij.w() / ij.rho_j();
        Real depth(0);
        unroll<Dim>([&](int k) __attribute__((always_inline)) { depth += Real(gravity[k]) * ij.x_ij[k]; });
        return {{v_w, v_w * (ij.p_j() + ij.rho_j() * depth)}};
    }
};

/// The same sums for ghosts that are accelerated each in their own way: Σ_f V_f W_wf, Σ_f V_f p_f W_wf and
/// Σ_f V_f ρ_f (x_w − x_f) W_wf.
template <int Dim>
struct MovingGhostPressureSums {
    static constexpr std::string_view name = "ghost pressure";
    static constexpr int dim = Dim, outputs = 2 + Dim;
    static constexpr ColumnSet reads_i = {}, reads_j = column::mass | column::density | column::pressure;

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real m_w = ij.m_w(), v_w = m_w * reciprocal(ij.rho_j());
        Vec<outputs, Real> out;
        out[0] = v_w;
        out[1] = v_w * ij.p_j();
        unroll<Dim>([&](int k) __attribute__((always_inline)) { out[2 + k] = m_w * ij.x_ij[k]; });
        return out;
    }
};

}  // namespace sluice
