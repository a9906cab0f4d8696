// What a term sees of a pair: two particles, their separation and the smoothing function.
#pragma once

#include <limits>

#include "kernels/pairs/particle_view.hpp"
#include "kernels/smoothing.hpp"

namespace sluice {

/// The product of a symmetric tensor, stored as sym_components<Dim> numbers, with a vector.
template <int Dim, class Real>
[[gnu::always_inline]] inline Vec<Dim, Real> sym_times(const Vec<sym_components<Dim>, Real>& s,
                                                       const Vec<Dim, Real>& v) {
    if constexpr (Dim == 2)
        return {{s[0] * v[0] + s[2] * v[1], s[2] * v[0] + s[1] * v[1]}};
    else
        return {{s[0] * v[0] + s[3] * v[1] + s[4] * v[2], s[3] * v[0] + s[1] * v[1] + s[5] * v[2],
                 s[4] * v[0] + s[5] * v[1] + s[2] * v[2]}};
}

/// The product of a tensor, stored row by row, with a vector.
template <int Dim, class Real>
[[gnu::always_inline]] inline Vec<Dim, Real> full_times(const Vec<Dim * Dim, Real>& t, const Vec<Dim, Real>& v) {
    Vec<Dim, Real> r;
    unroll<Dim>([&](int i) __attribute__((always_inline)) {
        r[i] = t[i * Dim] * v[0];
        unroll<Dim - 1>([&](int j) __attribute__((always_inline)) { r[i] += t[i * Dim + j + 1] * v[j + 1]; });
    });
    return r;
}

/// Which smoothing length a pass uses: the pair's mean, or one side's where the other has none.
enum class Length { mean, of_i, of_j };

/// A directed pair: what j does to i. x_ij = x_i − x_j; the smoothing length is the pair's mean, h = (h_i + h_j)/2, so
/// that W_ij = W_ji and ∇_i W_ij = −∇_j W_ij also between particles of unequal size: every antisymmetric term
/// conserves momentum. `Real` is a register of several pairs (neighbor/pack.hpp); terms are written as for one.
///
/// Products are written so that what is known early is multiplied first: a loop's speed is that of its longest chain.
///
/// A pair outside the support has W = 0 and ∇W = 0, and so has a particle with itself (∇W): terms need no test.
template <int Dim, class SideI, class SideJ>
struct Pair {
    using Real = typename SideI::Real;
    using Vector = Vec<Dim, Real>;
#define SLUICE_GETTER [[gnu::always_inline]]

    const Smoothing<Dim>& smoothing;
    const SideI& side_i;
    const SideJ& side_j;
    Vector x_ij;
    Real r2;         ///< |x_ij|², kept off zero by the smallest number
    Real inverse_r;  ///< 1/|x_ij|; finite at 0, where q = 0 gives slope 0, and ∇W = 0 without a division by zero
    Real h;          ///< mean smoothing length, or the one that the pass asks for (Length)
    Real inverse_h;
    Real scale;        ///< σ/h^Dim
    Real slope_scale;  ///< σ/h^(Dim+1), with the smoothing function's own constant

    /// |x_ij|/h
    SLUICE_GETTER Real q() const { return (r2 * inverse_h) * inverse_r; }
    /// w(q), dimensionless
    SLUICE_GETTER Real shape() const { return smoothing.shape(q()); }
    /// W_ij [1/m^Dim]
    SLUICE_GETTER Real w() const { return scale * shape(); }
    /// m_j W_ij
    SLUICE_GETTER Real m_w() const { return (scale * m_j()) * shape(); }
    /// ∇_i W_ij / x_ij, a scalar: (1/r) dW/dr
    SLUICE_GETTER Real grad_w_over_x() const { return slope_scale * (inverse_r * smoothing.reduced_slope(q())); }
    /// m_j ∇_i W_ij / x_ij
    SLUICE_GETTER Real m_grad_w_over_x() const {
        return ((slope_scale * m_j()) * inverse_r) * smoothing.reduced_slope(q());
    }

    /// The value of a column that the term reads, of i or of j.
    template <Column C>
    SLUICE_GETTER auto i(ColumnTag<C>) const {
        return side_i.template get<C>();
    }
    template <Column C>
    SLUICE_GETTER auto j(ColumnTag<C>) const {
        return side_j.template get<C>();
    }

    // The same, by symbol.
    SLUICE_GETTER Vector v_i() const { return i(column::velocity); }
    SLUICE_GETTER Vector v_j() const { return j(column::velocity); }
    SLUICE_GETTER Vector v_ij() const { return v_i() - v_j(); }
    SLUICE_GETTER Real m_j() const { return j(column::mass); }
    SLUICE_GETTER Real volume_j() const { return j(column::volume); }
    SLUICE_GETTER Real rho_i() const { return i(column::density); }
    SLUICE_GETTER Real rho_j() const { return j(column::density); }
    SLUICE_GETTER Real p_i() const { return i(column::pressure); }
    SLUICE_GETTER Real p_j() const { return j(column::pressure); }
    SLUICE_GETTER Real p_over_rho2_i() const { return i(column::pressure_over_rho2); }
    SLUICE_GETTER Real p_over_rho2_j() const { return j(column::pressure_over_rho2); }

    /// x_i − x_j where the particles are now, for passes whose place, and so x_ij, is in the reference configuration.
    SLUICE_GETTER Vector current_x_ij() const { return i(column::position) - j(column::position); }
#undef SLUICE_GETTER
};

}  // namespace sluice
