// Passes of particle shifting: what particle_shift (kernels/terms/particle_shift.hpp) needs to know of each particle.
//
// In a step: clear_surroundings; shift_sums over the fluid, and boundary_shift_sums over each kind of boundary that the fluid stands
// at; mark_free_surface, then what refreshes ghosts; surface_normals; particle_shift for each particle.
#pragma once

#include <cstdint>

#include "kernels/pairs/block_loop.hpp"
#include "kernels/terms/particle_shift.hpp"

namespace sluice {

/// Sums of the fluid's columns that particle shifting has to itself: all zero, `owned` of them, and `all` with ghosts.
template <int Dim>
void clear_surroundings(Columns<Dim>& fluid, std::size_t owned, std::size_t all);

template <int Dim>
Surroundings<Dim> surroundings_of(const Columns<Dim>& fluid, std::size_t i) {
    return {fluid.concentration_gradient[i], fluid.position_divergence[i], fluid.surface_normal[i]};
}

/// ∇C, ∇·x and Σ V W += the sums over fluid particles, V = m/ρ; in Σ V W the particle itself counts, which must stand
/// in its own list. Returns the directed pairs inside the support, as all of these do.
template <int Dim>
std::uint64_t shift_sums(const ParticleView<Dim>& fluid, const NeighborList& list, const ShiftTerms& terms,
                         const PairMethod<Dim>& method, Columns<Dim>& to);

/// The same over a boundary's particles, V their column `volume`.
template <int Dim>
std::uint64_t boundary_shift_sums(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary,
                                  const NeighborList& list, const ShiftTerms& terms, const PairMethod<Dim>& method,
                                  Columns<Dim>& to);

/// surface_volume of the first `owned` particles, from ∇·x.
template <int Dim>
void mark_free_surface(const ParticleView<Dim>& fluid, std::size_t owned, Columns<Dim>& to);

/// N += the sum over fluid particles with a surface_volume.
template <int Dim>
std::uint64_t surface_normals(const ParticleView<Dim>& fluid, const NeighborList& list, const PairMethod<Dim>& method,
                              Columns<Dim>& to);

}  // namespace sluice
