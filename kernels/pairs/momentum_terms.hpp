// Passes that sum terms of the momentum equation.
#pragma once

#include <type_traits>

#include "kernels/pairs/pair.hpp"
#include "kernels/pairs/pass_name.hpp"

namespace sluice {

/// Accelerations Σ_j m_j T_ij ∇_i W_ij. A term returns its share of T: a symmetric tensor, or a scalar that stands for
/// a multiple of the unit tensor. Terms that a scene does not call for are not in the pack.
template <int Dim, class... Terms>
struct MomentumTerms : Terms... {
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr ColumnSet reads_i = (Terms::reads_i | ...), reads_j = column::mass | (Terms::reads_j | ...);

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ij) const {
        const auto t = sum_of<typename Pair::Real>(Terms::operator()(ij)...);
        if constexpr (std::is_same_v<std::decay_t<decltype(t)>, typename Pair::Real>)
            return (t * ij.m_grad_w_over_x()) * ij.x_ij;
        else
            return ij.m_grad_w_over_x() * sym_times<Dim>(t, ij.x_ij);
    }

  private:
    template <class Real, class T>
    [[gnu::always_inline]] static T sum_of(const T& t) {
        return t;
    }
    template <class Real, class T, class U, class... Rest>
    [[gnu::always_inline]] static auto sum_of(const T& t, const U& u, const Rest&... rest) {
        if constexpr (std::is_same_v<T, U>)
            return sum_of<Real>(T(t + u), rest...);
        else if constexpr (std::is_same_v<U, Real>) {
            T sum = t;  // the diagonal comes first
            unroll<Dim>([&](int k) __attribute__((always_inline)) { sum[k] += u; });
            return sum_of<Real>(sum, rest...);
        } else
            return sum_of<Real>(u, t, rest...);
    }
};

}  // namespace sluice
