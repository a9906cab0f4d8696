// The passes between fluid and moving boundary, as sets of terms. Double in every precision: action must equal reaction
// to the last digits although each side sums for itself.
#pragma once

#include <string_view>

#include "kernels/pairs/pair.hpp"
#include "kernels/terms/boundary_viscosity.hpp"
#include "kernels/terms/moving_boundary.hpp"

namespace sluice {

template <int Dim>
struct BoundaryPressure : MovingBoundaryPressure<Dim> {
    static constexpr std::string_view name = "boundary force";
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
};

template <int Dim>
struct BoundaryReaction : MovingBoundaryReaction<Dim> {
    static constexpr std::string_view name = "boundary reaction";
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
};

template <int Dim>
struct BoundaryContinuity : MovingBoundaryContinuity {
    static constexpr std::string_view name = "boundary continuity";
    static constexpr int dim = Dim, outputs = 1;
    static constexpr bool always_full = true;

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& ij) const {
        return {{MovingBoundaryContinuity::operator()(ij)}};
    }
};

template <int Dim>
struct BoundaryFrictionPass : BoundaryFriction {
    static constexpr std::string_view name = "boundary friction";
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
};

template <int Dim>
struct BoundaryFrictionReactionPass : BoundaryFrictionReaction {
    static constexpr std::string_view name = "friction reaction";
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
};

/// Σ_f V_f W_wf and Σ_f V_f W_wf v_f of a boundary particle w.
template <int Dim>
struct BoundaryVelocitySums {
    static constexpr std::string_view name = "ghost velocity";
    static constexpr int dim = Dim, outputs = 1 + Dim;
    static constexpr bool always_full = true;
    static constexpr ColumnSet reads_i = {}, reads_j = column::mass | column::density | column::velocity;

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& wf) const {
        const auto v_w = wf.m_w() * reciprocal(wf.rho_j());
        const auto v_f = wf.v_j();
        Vec<outputs, typename Pair::Real> out;
        out[0] = v_w;
        unroll<Dim>([&](int k) __attribute__((always_inline)) { out[1 + k] = v_w * v_f[k]; });
        return out;
    }
};

}  // namespace sluice
