// Measures of a deformation gradient F = I + H that elastic laws are made of.
#pragma once

#include "kernels/tensor.hpp"

namespace sluice {

/// det(F) F⁻ᵀ = ∂ det(F)/∂F, without a division: finite for every F.
inline Tensor<2> cofactor(const Tensor<2>& f) {
    Tensor<2> c;
    c << f(1, 1), -f(1, 0), -f(0, 1), f(0, 0);
    return c;
}
inline Tensor<3> cofactor(const Tensor<3>& f) {
    Tensor<3> c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            c(i, j) = f(i1, j1) * f(i2, j2) - f(i1, j2) * f(i2, j1);
        }
    return c;
}

/// det(I + H) − 1 by the invariants of H: no digits are lost at small strains.
template <int Dim>
double volume_change(const Tensor<Dim>& h) {
    if constexpr (Dim == 2)
        return h.trace() + h.determinant();
    else
        return h.trace() + cofactor(h).trace() + h.determinant();
}

/// E = (FᵀF − I)/2 of H = F − I.
template <int Dim>
Tensor<Dim> green_strain(const Tensor<Dim>& h) {
    return 0.5 * (h + h.transpose() + h.transpose() * h);
}

}  // namespace sluice
