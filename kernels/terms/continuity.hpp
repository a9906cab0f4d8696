#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Continuity equation [Antoci2007, eq. 8]; zero for a uniform velocity.
///   dρ_i/dt = Σ_j m_j v_ij · ∇_i W_ij          [kg/m³/s]
struct Continuity {
    static constexpr ColumnSet reads_i = column::velocity, reads_j = column::mass | column::velocity;

    template <class Pair>
    [[gnu::always_inline]] auto operator()(const Pair& ij) const {
        return ij.m_grad_w_over_x() * dot(ij.v_ij(), ij.x_ij);
    }
};

}  // namespace sluice
