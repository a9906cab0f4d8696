// Interpolation from scattered points that is exact for affine fields, also a little outside the points.
#pragma once

#include <optional>
#include <vector>

#include "neighbor/vec.hpp"

namespace sluice {

/// One point's share in the interpolated value.
struct Share {
    std::size_t point;
    double weight;
};

/// Shares of the points nearer to `at` than `radius`, by moving least squares with a linear basis and cubic-spline
/// weights [Lancaster & Salkauskas 1981]:
///   w_i = W_i p_i·M⁻¹p(at),   M = Σ_i W_i p_i p_iᵀ,   p = (1, x, y[, z])
/// They sum to 1 and reproduce affine fields. Nothing if the points are too few or do not span the space.
template <int Dim>
std::optional<std::vector<Share>> least_squares_shares(const std::vector<Vec<Dim>>& points, const Vec<Dim>& at,
                                                       double radius);

}  // namespace sluice
