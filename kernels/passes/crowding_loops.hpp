// The pass that finds particles too close to each other. It runs seldom: in double whatever is asked for.
#pragma once

#include <string_view>

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// Σ_j max(1 − r²/(c h)², 0), h of the pair.
template <int Dim>
struct Crowding {
    static constexpr std::string_view name = "crowding";
    static constexpr int dim = Dim, outputs = 1;
    static constexpr bool always_full = true;
    static constexpr ColumnSet reads_i = {}, reads_j = {};

    double inverse_reach2 = 0;  ///< 1/c²

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real q2 = (ij.inverse_h * ij.inverse_h) * ij.r2;
        return {{larger(Real(1) - Real(inverse_reach2) * q2, Real(0))}};
    }
};

}  // namespace sluice
