#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Pressure of a rigid wall's fixed ghosts on the fluid: eq. (10) with a ghost of volume V_j at rest, whose density is
/// that of the fluid particle that feels it, ρ_j = ρ_i.
///   a_i = −1/ρ_i Σ_j V_j (p_i + p_j) ∇_i W_ij          [m/s²]
struct FixedGhostPressure {
    static constexpr ColumnSet reads_i = column::pressure | column::density, reads_j = column::volume | column::pressure;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ij) const {
        return (-ij.volume_j() * (ij.p_i() + ij.p_j()) / ij.rho_i() * ij.grad_w_over_x()) * ij.x_ij;
    }
};

/// Continuity across a rigid wall: eq. (8) with a ghost at rest.
///   dρ_i/dt = ρ_i Σ_j V_j v_i · ∇_i W_ij          [kg/m³/s]
struct FixedGhostContinuity {
    static constexpr ColumnSet reads_i = column::velocity | column::density, reads_j = column::volume;

    template <class Pair>
    [[gnu::always_inline]] auto operator()(const Pair& ij) const {
        return ij.rho_i() * ij.volume_j() * ij.grad_w_over_x() * dot(ij.v_i(), ij.x_ij);
    }
};

}  // namespace sluice
