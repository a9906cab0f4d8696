// Small tensors per particle: Eigen matrices, and their packed symmetric form.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "neighbor/fields.hpp"

namespace sluice {

template <int Dim>
using Tensor = Eigen::Matrix<double, Dim, Dim>;

/// A particle with det Σ_j V_j (x_j − x_i) ⊗ ∇W below this has too few neighbours to define a gradient; a full support
/// has 1.
inline constexpr double smallest_moment = 1e-3;

template <int Dim>
Tensor<Dim> sym_to_tensor(const Vec<sym_components<Dim>>& s) {
    Tensor<Dim> t;
    if constexpr (Dim == 2)
        t << s[0], s[2], s[2], s[1];
    else
        t << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
    return t;
}

/// Of a symmetric tensor; the upper triangle is read.
template <int Dim>
Vec<sym_components<Dim>> tensor_to_sym(const Tensor<Dim>& t) {
    if constexpr (Dim == 2)
        return {{t(0, 0), t(1, 1), t(0, 1)}};
    else
        return {{t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(0, 2), t(1, 2)}};
}

/// Row by row.
template <int Dim>
Vec<Dim * Dim> rows_of(const Tensor<Dim>& t) {
    Vec<Dim * Dim> rows;
    for (int k = 0; k < Dim * Dim; ++k) rows[k] = t(k / Dim, k % Dim);
    return rows;
}

/// Of a tensor stored row by row.
template <int Dim>
Tensor<Dim> tensor_of(const Vec<Dim * Dim>& rows) {
    Tensor<Dim> t;
    for (int k = 0; k < Dim * Dim; ++k) t(k / Dim, k % Dim) = rows[k];
    return t;
}

}  // namespace sluice
