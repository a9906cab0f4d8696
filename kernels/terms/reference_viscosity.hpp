#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Artificial viscosity of a solid in its reference configuration: that of ArtificialViscosity, with its weight ∇W of
/// the reference positions X and its direction that of the current ones x. Acts on approaching pairs only.
///   f_ij = V_i V_j η h min(v_ij·x_ij, 0)/(|x_ij|² + (0.1 h)²) W'(|X_ij|)/|X_ij| x_ij,   η = α ρ0 c0          [N]
/// Along the line between the two, whatever the body's rotation: it keeps angular momentum, and f·v_ij ≤ 0. Returns
/// what stands before W'/|X| x_ij, over V_i V_j.
struct ReferenceViscosity {
    static constexpr ColumnSet reads_i = column::velocity | column::position, reads_j = reads_i;

    double coefficient = 0;  ///< η [kg/(m² s)]

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const auto x_ij = ij.current_x_ij();
        const Real approach = smaller(dot(ij.v_ij(), x_ij), Real(0));
        const Real distance2 = dot(x_ij, x_ij) + Real(0.01) * ij.h * ij.h;
        return (Real(coefficient) * ij.h) * approach * reciprocal(distance2);
    }
};

}  // namespace sluice
