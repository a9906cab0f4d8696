// The passes of particle shifting, as sets of terms.
#pragma once

#include <string_view>

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// A neighbour's volume: of fluid particles m/ρ, of a boundary's particles a column of its own.
struct VolumeOfMass {
    static constexpr ColumnSet reads_j = column::mass | column::density;

    template <class Pair>
    [[gnu::always_inline]] static typename Pair::Real of(const Pair& ij) {
        return ij.m_j() * reciprocal(ij.rho_j());
    }
};
struct VolumeColumn {
    static constexpr ColumnSet reads_j = column::volume;

    template <class Pair>
    [[gnu::always_inline]] static typename Pair::Real of(const Pair& ij) {
        return ij.volume_j();
    }
};

/// Σ_j V_j (1 + R (W_ij/W(d))^4) ∇W, −Σ_j V_j x_ij·∇W and Σ_j V_j W. W(d) is taken at the pair's own spacing, as in
/// ArtificialStress.
template <int Dim, class Volume>
struct ConcentrationSums {
    static constexpr std::string_view name = "concentration";
    static constexpr int dim = Dim, outputs = Dim + 2;
    static constexpr ColumnSet reads_i = {}, reads_j = Volume::reads_j;

    double repulsion = 0;                 ///< R
    double inverse_shape_at_spacing = 0;  ///< 1/w(d/h)

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real volume = Volume::of(ij), slope = volume * ij.grad_w_over_x(), shape = ij.shape();
        const Real f = Real(inverse_shape_at_spacing) * shape, f2 = f * f;
        const Real weighted = slope * (Real(1) + Real(repulsion) * (f2 * f2));
        Vec<outputs, Real> out;
        unroll<Dim>([&](int k) __attribute__((always_inline)) { out[k] = weighted * ij.x_ij[k]; });
        out[Dim] = -(slope * ij.r2);
        out[Dim + 1] = (volume * ij.scale) * shape;
        return out;
    }
};

template <int Dim>
using FluidConcentration = ConcentrationSums<Dim, VolumeOfMass>;

/// Few pairs: in double whatever is asked for, which spares compiling the other.
template <int Dim>
struct BoundaryConcentration : ConcentrationSums<Dim, VolumeColumn> {
    static constexpr std::string_view name = "boundary concentration";
    static constexpr bool always_full = true;
};

/// Σ_j V_j ∇W
template <int Dim>
struct SurfaceNormal {
    static constexpr std::string_view name = "surface normal";
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr ColumnSet reads_i = {}, reads_j = column::volume;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ij) const {
        return (ij.volume_j() * ij.grad_w_over_x()) * ij.x_ij;
    }
};

}  // namespace sluice
