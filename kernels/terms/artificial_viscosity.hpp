#pragma once

#include "kernels/terms/central_viscosity.hpp"

namespace sluice {

/// Artificial viscosity [Antoci2007, eq. 12; Monaghan & Gingold 1983]; acts on approaching pairs only.
///   a_i = −Σ_j m_j Π_ij ∇_i W_ij,   Π_ij = −α c μ_ij / ρ̄_ij if v_ij·x_ij < 0, else 0          [m/s²]
///   μ_ij = h v_ij·x_ij / (|x_ij|² + (0.1 h)²)
/// Both partners are of one medium, so the mean sound speed c̄ is that medium's c0.
///
/// Over all pairs it would be the laminar viscosity ν = α h c/(2(D + 2)) [Monaghan 2005, sec. 8.2]. In a shear flow
/// half of the pairs approach: ν = α h c/(4(D + 2)), α h c/16 in 2D and α h c/20 in 3D.
struct ArtificialViscosity {
    static constexpr ColumnSet reads_i = CentralViscosity::reads_i, reads_j = CentralViscosity::reads_j;

    double alpha = 0;        ///< α
    double sound_speed = 0;  ///< c [m/s]

    CentralViscosity central() const { return {alpha * sound_speed, 0, 0, 0.01}; }

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Real operator()(const Pair& ij) const {
        return central()(ij);
    }
};

}  // namespace sluice
