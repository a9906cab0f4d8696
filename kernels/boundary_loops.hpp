// The passes between fluid and moving boundary, as sets of terms. Double in every precision: action must equal reaction
// to the last digits although each side sums for itself.
#pragma once

#include "kernels/pair_sum.hpp"
#include "kernels/terms/moving_boundary.hpp"

namespace sluice {

template <int Dim>
struct BoundaryPressure : MovingBoundaryPressure<Dim> {
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
};

template <int Dim>
struct BoundaryReaction : MovingBoundaryReaction<Dim> {
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr bool always_full = true;
};

template <int Dim>
struct BoundaryContinuity : MovingBoundaryContinuity {
    static constexpr int dim = Dim, outputs = 1;
    static constexpr bool always_full = true;

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& ij) const {
        return {{MovingBoundaryContinuity::operator()(ij)}};
    }
};

}  // namespace sluice
