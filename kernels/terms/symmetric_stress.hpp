#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Stress part of the solid's momentum equation [Antoci2007, eq. 11], σ = −p I + S; equal and opposite within a pair.
///   a_i = Σ_j m_j (σ_i/ρ_i² + σ_j/ρ_j²) ∇_i W_ij          [m/s²]
struct SymmetricStress {
    static constexpr ColumnSet reads_i = column::stress_over_rho2, reads_j = column::mass | column::stress_over_rho2;

    template <class Pair>
    [[gnu::always_inline]] auto operator()(const Pair& ij) const {
        return ij.i(column::stress_over_rho2) + ij.j(column::stress_over_rho2);
    }
};

}  // namespace sluice
