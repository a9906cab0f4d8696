#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Pressure part of the momentum equation [Antoci2007, eq. 10]; equal and opposite within a pair.
///   a_i = −Σ_j m_j (p_i/ρ_i² + p_j/ρ_j²) ∇_i W_ij          [m/s²]
struct SymmetricPressure {
    static constexpr ColumnSet reads_i = column::pressure_over_rho2, reads_j = column::mass | column::pressure_over_rho2;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        return -(ij.p_over_rho2_i() + ij.p_over_rho2_j());
    }
};

}  // namespace sluice
