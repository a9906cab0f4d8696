// What a term sees: two particles, their separation and their smoothing function.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "kernels/smoothing.hpp"
#include "neighbor/fields.hpp"

namespace sluice {

/// Read-only columns of a set of particles. A pass fills in the columns that its terms read; the others stay null.
template <int Dim>
struct ParticleView {
    template <int N>
    using Columns = std::array<const double*, N>;

    Columns<Dim> position{};                           ///< [m]
    Columns<Dim> velocity{};                           ///< [m/s]
    const double* smoothing_length = nullptr;          ///< h [m]
    const double* mass = nullptr;                      ///< m [kg; kg/m in 2D]
    const double* volume = nullptr;                    ///< V [m³; m² in 2D], of fixed ghosts
    const double* density = nullptr;                   ///< ρ [kg/m³]
    const double* pressure = nullptr;                  ///< p [Pa]
    const double* pressure_over_rho2 = nullptr;        ///< p/ρ² [Pa m⁶/kg²]
    Columns<sym_components<Dim>> stress_over_rho2{};   ///< σ/ρ²
    Columns<sym_components<Dim>> artificial_stress{};  ///< R of eq. (14)
};

/// Columns of a tuple field as raw pointers.
template <int N>
std::array<const double*, N> columns_of(const TupleField<N>& field) {
    std::array<const double*, N> p;
    for (std::size_t k = 0; k < N; ++k) p[k] = field.c[k].data();
    return p;
}

/// One entry of a tuple of columns, in the real type of the pair arithmetic.
template <class Real, std::size_t N>
Vec<static_cast<int>(N), Real> at(const std::array<const double*, N>& columns, Index i) {
    Vec<static_cast<int>(N), Real> v;
    for (std::size_t k = 0; k < N; ++k) v[static_cast<int>(k)] = static_cast<Real>(columns[k][i]);
    return v;
}

/// The product of a symmetric tensor, stored as sym_components<Dim> numbers, with a vector.
template <int Dim, class Real>
Vec<Dim, Real> sym_times(const Vec<sym_components<Dim>, Real>& s, const Vec<Dim, Real>& v) {
    if constexpr (Dim == 2)
        return {{s[0] * v[0] + s[2] * v[1], s[2] * v[0] + s[1] * v[1]}};
    else
        return {{s[0] * v[0] + s[3] * v[1] + s[4] * v[2], s[3] * v[0] + s[1] * v[1] + s[5] * v[2],
                 s[4] * v[0] + s[5] * v[1] + s[2] * v[2]}};
}

/// A directed pair: what j does to i. x_ij = x_i − x_j; the smoothing length is the pair's mean, h = (h_i + h_j)/2, so
/// that W_ij = W_ji and ∇_i W_ij = −∇_j W_ij also between particles of unequal size: every antisymmetric term
/// conserves momentum. `Self` holds i's values, `Tile` a block of partners, of which j is one lane (kernels/tile.hpp).
///
/// A pair outside the support has W = 0 and ∇W = 0, and so has a particle with itself (∇W): terms need no test.
template <int Dim, class Real_, class Smoothing, class Self, class Tile>
struct Pair {
    using Real = Real_;
    using Vector = Vec<Dim, Real>;
    using Tensor = Vec<sym_components<Dim>, Real>;

    const Self& self;
    const Tile& tile;
    int j;  ///< lane
    Vector x_ij;
    Real r2;  ///< |x_ij|²
    Real h;   ///< mean smoothing length
    Real inverse_h;
    Real scale;  ///< σ/h^Dim

    /// |x_ij|, kept off zero: q = 0 then gives slope 0, and ∇W = 0 without a division by zero.
    Real r() const { return std::sqrt(larger(r2, std::numeric_limits<Real>::min())); }
    /// w(q), dimensionless
    Real shape() const { return Smoothing::shape(r() * inverse_h); }
    /// W_ij [1/m^Dim]
    Real w() const { return scale * shape(); }
    /// ∇_i W_ij
    Vector grad_w() const {
        const Real distance = r();
        return (scale * inverse_h * Smoothing::slope(distance * inverse_h) / distance) * x_ij;
    }

    Vector v_i() const { return self.velocity; }
    Vector v_ij() const { return self.velocity - tile.template tuple<Dim>(tile.velocity, j); }
    Real m_j() const { return tile.mass[j]; }
    Real volume_j() const { return tile.volume[j]; }
    Real rho_i() const { return self.density; }
    Real rho_j() const { return tile.density[j]; }
    Real p_i() const { return self.pressure; }
    Real p_j() const { return tile.pressure[j]; }
    Real p_over_rho2_i() const { return self.pressure_over_rho2; }
    Real p_over_rho2_j() const { return tile.pressure_over_rho2[j]; }
    Tensor stress_over_rho2_i() const { return self.stress_over_rho2; }
    Tensor stress_over_rho2_j() const { return tile.template tuple<sym_components<Dim>>(tile.stress_over_rho2, j); }
    Tensor artificial_stress_i() const { return self.artificial_stress; }
    Tensor artificial_stress_j() const { return tile.template tuple<sym_components<Dim>>(tile.artificial_stress, j); }
};

}  // namespace sluice
