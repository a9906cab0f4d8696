// Particle shifting: small displacements towards an even arrangement, particle by particle from sums over pairs.
//
// ∇C_i = Σ_j V_j (1 + R (W_ij/W(d))^4) ∇_i W_ij          [1/m]
// points to where particles stand closer; R = 0.2 keeps pairs from forming [Monaghan 2000; Lind et al. 2012]. Then
//   δx_i = −A h |v_i| Δt ∇C_i,   A = 2 [Skillen et al. 2013].
// The displacement per time does not depend on the step, unlike −½ h² ∇C per step [Lind et al. 2012], and a fluid at
// rest is left alone. With the largest speed of all in place of |v_i| it is that of Sun et al. 2017, −CFL Ma (2h)² ½ ∇C
// for a step of CFL h/c0.
//
// At a free surface ∇C is large and points inwards: half of the support is missing. The surface is where
//   ∇·x_i = −Σ_j V_j x_ij·∇_i W_ij,   D inside,
// falls below a threshold [Lee et al. 2008]. Those particles are not shifted. Any other that has one of them in its
// support is shifted along the surface only, whose normal is N_i = Σ_s V_s ∇_i W_is over the surface's particles s
// alone:
//   δx ← δx − (δx·n) n,   n = N_i/|N_i|.
// N takes a second pass over the pairs. Without it one would fade δx out by ∇·x_i itself; but ∇C's own direction is the
// only normal that one has then, so nothing is left to shift along the surface, and what is not faded out draws the
// second layer to the first: in 400 steps of |v| Δt = 0.05 d by 0.02 to 0.3 d (2D, h/d = 1.3 and 1.5, faded out between
// 1 and 0.75 D or 1 and 0.9 D), where with N it stays within 0.01 d.
#pragma once

#include <cmath>

#include "neighbor/vec.hpp"

namespace sluice {

struct ShiftTerms {
    double h_over_d = 0;     ///< smoothing length over spacing
    double strength = 2;     ///< A
    double repulsion = 0.2;  ///< R
    double largest = 0.2;    ///< longest displacement, over d; Lind et al. 2012 have 0.2 h
};

/// ∇·x below which a particle is at the free surface: 1.5 in 2D [Lee et al. 2008]. On a lattice with h/d from 1.2
/// to 1.8, a flat surface's first layer has up to 1.32 in 2D and 2.18 in 3D, and the second at least 1.52 and 2.42, for
/// all of the smoothing functions. With more neighbours the second layer is taken for a surface too.
template <int Dim>
inline constexpr double surface_divergence = Dim == 2 ? 1.5 : 2.4;

/// What is known of a particle's surroundings.
template <int Dim>
struct Surroundings {
    Vec<Dim> concentration_gradient;  ///< ∇C [1/m]
    double position_divergence = 0;   ///< ∇·x
    Vec<Dim> surface_normal;          ///< N, towards the surface; exactly 0 where none is near [1/m]
};

/// δx of a particle with smoothing length h that goes `path` = |v| Δt in this step. [m]
template <int Dim>
Vec<Dim> particle_shift(const ShiftTerms& terms, const Surroundings<Dim>& around, double h, double path) {
    if (around.position_divergence < surface_divergence<Dim>) return {};
    Vec<Dim> shift = (-terms.strength * h * path) * around.concentration_gradient;
    const Vec<Dim>& normal = around.surface_normal;
    const double normal2 = norm2(normal);
    if (normal2 > 0) shift -= (dot(shift, normal) / normal2) * normal;
    const double length = norm(shift), limit = terms.largest * h / terms.h_over_d;
    return length > limit ? (limit / length) * shift : shift;
}

}  // namespace sluice
