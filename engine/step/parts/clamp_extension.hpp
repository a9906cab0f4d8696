// How a clamp looks to its neighbours: behind the clamp's surface the displacement continues as its mirror image.
//
// A clamp holds the solid at a surface, u = 0 there, and whatever lies behind is rigid. Strain is not: it ends at the
// surface with a jump. A gradient summed over free and held particles alike sees half of it on either side, and energy,
// which goes with its square, too little: a plate acts as if it were longer by about half an h, an error of first
// order. So displacement is made odd about the surface,
//   u(X_b) = −r u(X_j),   r = s_b/s_j,
// which is exact for every linear field that is zero at the surface's point X_s between the two, s_b below it and s_j
// above, and right to second order for others [as velocity behind walls without slip, Takeda, Miyama & Sekiya 1994;
// Morris, Fox & Zhu 1997, section 3.6]. Of the free particles j is the one nearest to the mirror image of b; on a
// lattice that the surface cuts half-way it is that image, and r = 1.
//
// What is behind the surface has no energy. Where the surface cuts particles' cells, as an arc must, each has that
// share of its energy which its cell has outside the clamp, be its centre held or not: ψ and k of
// kernels/passes/total_lagrangian_passes.hpp times `elastic_share`. And all whose cells are cut follow, those with
// their centre outside by s_b < 0, as u = s_b/s_j u_j. That keeps a bar under uniform strain in balance, which decides
// the order: with whole cells, or with cut ones that move by themselves, a bar acts as if it were up to a spacing, or
// 0.7 of it, longer than it is; so 0.04 at the most (one dimension, h = 1.2 d, surface anywhere between two particles).
//
// Particles whose share is 0 are rigid: L = 0 and k = 0, so that F = I and T = 0. What is left of the energy (b) of
// kernels/passes/total_lagrangian_passes.hpp depends on free particles only, directly and by way of those that follow,
// so that a force f_b on one of these is one of −r f_b on its j: f_j = −∂U/∂x_j, and energy is kept.
//
// Held as before, u = 0, are particles that have free ones on both sides of them, as in a body clamped in its middle
// only.
#pragma once

#include <cstdint>
#include <span>

#include "engine/particles/particle_set.hpp"
#include "engine/scene/scene.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice {

template <int Dim>
class ClampExtension {
  public:
    ClampExtension() = default;
    /// For particles where they are at the start; those that the clamp's surface cuts become clamped. `list` holds each
    /// one's neighbours in the reference configuration, `support` [m] is how far they reach.
    ClampExtension(const Scene& scene, ParticleSet<Dim>& solid, const NeighborList& list, double support);

    /// Marks the held particles that have no energy: 1 for each of them.
    std::span<const std::uint8_t> rigid() const { return rigid_; }
    /// Marks the held particles that follow free ones: 1 for each of them.
    std::span<const std::uint8_t> extended() const { return extended_; }
    bool empty() const { return pair_.empty(); }

    /// Sets elastic_share of each particle, multiplies k by it, and sets L = 0 for rigid ones.
    void share_energy(ParticleSet<Dim>& solid) const;
    /// Moves extended particles to where the mirror image of the displacement, and of the velocity, puts them.
    void displace(ParticleSet<Dim>& solid) const;
    /// Passes the force on extended particles to those that they follow, and puts them back.
    void hand_over(ParticleSet<Dim>& solid) const;
    void put_back(ParticleSet<Dim>& solid) const;

  private:
    /// Particle `behind` the surface, or cut by it, follows free particle `of`.
    struct Pair {
        Index behind = 0, of = 0;
        double ratio = 0;          ///< r; negative for those in front of the surface
        Vec<Dim> start, start_of;  ///< where both were at the start [m]
    };

    Array<Pair> pair_;
    Array<std::uint8_t> rigid_, extended_;
    ScalarField share_;  ///< of each particle's energy
};

extern template class ClampExtension<2>;
extern template class ClampExtension<3>;

}  // namespace sluice
