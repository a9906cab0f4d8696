// Passes of particle shifting: what particle_shift (kernels/terms/particle_shift.hpp) needs to know of each particle.
//
// In a step: reset; shift_sums over the fluid, and boundary_shift_sums over each kind of boundary that the fluid stands
// at; mark_free_surface, then what refreshes images; surface_normals; particle_shift for each particle.
#pragma once

#include <cstdint>

#include "kernels/block_loop.hpp"
#include "kernels/terms/particle_shift.hpp"

namespace sluice {

/// The surroundings of all particles.
template <int Dim>
struct ShiftFields {
    VectorField<Dim> concentration_gradient;  ///< ∇C [1/m]
    ScalarField position_divergence;          ///< ∇·x
    ScalarField concentration;                ///< Σ V W
    ScalarField surface_volume;               ///< V of particles at the free surface, 0 of the others [m³; m² in 2D]
    VectorField<Dim> surface_normal;          ///< N [1/m]

    /// For n particles, all zero.
    void reset(std::size_t n);
    Surroundings<Dim> operator[](std::size_t i) const {
        return {concentration_gradient[i], position_divergence[i], surface_normal[i]};
    }
};

/// ∇C, ∇·x and Σ V W += the sums over fluid particles, V = m/ρ; in Σ V W the particle itself counts, which must stand
/// in its own list. Returns the directed pairs inside the support, as all of these do.
template <int Dim>
std::uint64_t shift_sums(const ParticleView<Dim>& fluid, const NeighborList& list, const ShiftTerms& terms,
                         const PairMethod<Dim>& method, ShiftFields<Dim>& fields);

/// The same over a boundary's particles, V their column `volume`.
template <int Dim>
std::uint64_t boundary_shift_sums(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary,
                                  const NeighborList& list, const ShiftTerms& terms, const PairMethod<Dim>& method,
                                  ShiftFields<Dim>& fields);

/// surface_volume of the first `owned` particles, from ∇·x.
template <int Dim>
void mark_free_surface(const ParticleView<Dim>& fluid, std::size_t owned, ShiftFields<Dim>& fields);

/// N += the sum over fluid particles with a surface_volume.
template <int Dim>
std::uint64_t surface_normals(const ParticleView<Dim>& fluid, const NeighborList& list, const PairMethod<Dim>& method,
                              ShiftFields<Dim>& fields);

}  // namespace sluice
