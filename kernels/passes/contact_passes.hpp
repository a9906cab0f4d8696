// Contact between elastic bodies, and of bodies with walls, without friction.
//
// What a particle has near it of other bodies, at current positions x and reference volumes V, is its contact density
//   σ_i = Σ_j V_j W_ij,   j of other bodies only.
// It grows from 0 out of reach to 1 where two bodies fill the same place. Bodies touch where their surfaces do, half a
// spacing outside of their outer particles. For flat lattices in line that is a gap of one spacing d between the outer
// layers, where by the lattice's sum
//   σ_0 = Σ_(n: n_z ≥ 1) d^Dim W(|n| d, h),   σ_0' = −dσ/dz · d                                                     (a)
// What exceeds it costs energy, as compression does:
//   E = ½ k Σ_i V_i (σ_i − σ_0)₊²                                                                                  (b)
//   f_i = −∂E/∂x_i = −V_i Σ_j V_j (p_i + p_j) ∇_i W_ij,   p = k (σ − σ_0)₊ ≥ 0                                     (c)
// equal and opposite within a pair and along the line between the two: momentum is kept pair by pair and angular
// momentum with it, and the energy by a symplectic integrator. p is continuous, so the force is; it pushes only.
//
// Flat on flat, bodies that are closer by δ ≪ d press with
//   P = 2 k σ_0'² δ/d                                                                                              (d)
// (outer layers alone, both sides). Deeper in, W is steeper and so is P: δ stays below that.
//
// The same idea serves Campbell, Vignjevic & Libersky 2000 (a penalty in the overlap of supports, which begins at a gap
// of two h, and so holds bodies apart); the threshold is what lets surfaces touch. A particle's σ of its own body,
// which Seo & Min 2006 and others add to find surfaces, is not needed.
//
// A rigid wall of fixed particles pushes with twice the k and with the solid's sums alone (the wall feels nothing), so
// that (d) holds there too:
//   E = k Σ_i V_i (σ_i − σ_0)₊²,   f_i = −2 V_i k (σ_i − σ_0)₊ Σ_w V_w ∇_i W_iw                                    (e)
// A mirror plane at a distance z of the particle is (e) with σ − σ_0 = σ_0' (z_0 − z)/d:
//   E = k σ_0'² Σ_i V_i (z_0 − z_i)₊²/d²,   z_0 = d/2                                                              (f)
#pragma once

#include <cstdint>

#include "kernels/pairs/block_loop.hpp"

namespace sluice {

/// Two flat lattices that touch (a).
struct FlatContact {
    double density = 0;  ///< σ_0
    double slope = 0;    ///< σ_0'
};

/// Of lattices with h/d.
template <int Dim>
FlatContact flat_contact(const Smoothing<Dim>& smoothing, double h_over_d);

/// density = σ and gradient = Σ V ∇W for listed particles. Reads the others' volume.
template <int Dim>
std::uint64_t contact_sums(const ParticleView<Dim>& body, const ParticleView<Dim>& others, const NeighborList& list,
                           const PairMethod<Dim>& method, ScalarField& density, VectorField<Dim>& gradient);

/// force_density = f/V (c) for listed particles. Reads both sides' pressure and the others' volume.
template <int Dim>
std::uint64_t contact_force(const ParticleView<Dim>& body, const ParticleView<Dim>& others, const NeighborList& list,
                            const PairMethod<Dim>& method, VectorField<Dim>& force_density);

}  // namespace sluice
