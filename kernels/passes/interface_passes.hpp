// The interface between fluid and solid: pressure, force and reaction, kinematic condition.
//
// The interface Γ is a set of elements k with centre x_k, area normal n_k ΔΓ_k into the fluid, and the velocity v_k of
// the solid. W_kb stands for W(|x_k − x_b|, h_b) with the particle's own smoothing length. V = m/ρ.
//
// Pressure on an element [Antoci2007, eq. 26]. Half of the support is fluid, hence the 2; not normalised, so that it
// fades as the media part:
//   p_k = 2 Σ_b V_b p_b W_kb                                                            (fluid b)        (a)
//
// Force. The smoothed pressure gradient over a bounded domain has a surface term (eqs. 24, 25): per unit volume,
// −n p ∫_Γ W dΓ. The pair forms (10, 11), in which both partners' pressures stand, count a uniform pressure twice:
// −Σ_b m_b (p_a/ρ_a² + p_b/ρ_b²) ∇W = −(2p/ρ) Σ_b V_b ∇W, and for a half-space Σ_b V_b ∇_a W → +∫_Γ W n dΓ. Hence the
// surface term of this form is −2 n p ∫_Γ W dΓ (the factor that equation 27 lost). Check: over the layers of a solid
// half-space, ∫_0^∞ 2 p (∫_Γ W dΓ) ds = 2 p · ½ = p per unit area, the whole pressure, whatever the spacing.
//
// Solid's side. The force f_k = −p_k n_k ΔΓ_k goes to the solid particles a around the element with the weights of the
// same integral, normalised to one so that nothing is lost at corners and in thin plates:
//   F_a = Σ_k w_ka f_k,   w_ka = V_a W_ka / Σ_c V_c W_kc                                                  (b)
//
// Fluid's side. Equation 29 asks for the opposite force, and action must equal reaction. By (a) each fluid particle b
// contributes 2 V_b p_b W_kb ΔΓ_k to what it and its neighbours together exert on element k; so that is what it gets
// back:
//   F_b = Σ_k 2 V_b p_b W_kb n_k ΔΓ_k                                                                     (c)
// Σ_b F_b = Σ_k p_k n_k ΔΓ_k = −Σ_k f_k: pair by pair, for any geometry. It is also what keeps the wall layer stable.
// With (c) and (10) a particle at the interface feels −(1/ρ) Σ V_j (p_j − p_b) ∇W: higher pressure than its neighbours
// drives it away from the wall. If it got back the mean p_k instead, the excess p_b − p_k of its own pressure would
// press it *towards* the wall, and the layer would clump.
//
// Kinematic condition. The same surface term in the continuity equation, in the normal direction only (slip is free):
//   dρ_b/dt = −2 ρ_b Σ_k W_kb n_k ΔΓ_k · (v_b − v_k),   v_k = Σ_a w_ka v_a                               (d)
// The 2 is that of a mirrored ghost, which moves with 2 v_k − v_b. (b), (c) and (d) form a conservative system: the
// power of the forces, Σ_b F_b·v_b + Σ_a F_a·v_a = Σ_kb 2 V_b p_b W_kb n_k ΔΓ_k·(v_b − v_k), is exactly what the
// fluid's compression p/ρ² dρ/dt takes up.
//
// Pair arithmetic is double in every precision: these passes are small, and action must equal reaction to the last
// digits although each side sums for itself.
#pragma once

#include "kernels/pairs/block_loop.hpp"
#include "kernels/pairs/block_totals.hpp"

namespace sluice {

/// pressure of listed elements += (a). The others are left as they are. Lists between elements and particles have no
/// reach of the elements and twice the particles' (CutOff).
template <int Dim>
void add_interface_pressure(const ParticleView<Dim>& elements, const ParticleView<Dim>& fluid, const NeighborList& list,
                            const PairMethod<Dim>& method, ScalarField& pressure);

/// Σ_a V_a W_ka for each element, and v_k of (d) from the solid's velocity column. An element that its solid has left
/// behind has weight 0; nothing can take up a force on it, so the caller must take its area away.
template <int Dim>
void interface_weights(const ParticleView<Dim>& elements, const ParticleView<Dim>& solid, const NeighborList& list,
                       const PairMethod<Dim>& method, ScalarField& weight, VectorField<Dim>& velocity);

/// acceleration of the solid = F_a/m_a (b) for listed particles, from the elements' shared_force = f_k/Σ_c V_c W_kc.
/// Returns Σ_a F_a [N; N/m in 2D].
template <int Dim>
Vec<Dim> interface_force_on_solid(const ParticleView<Dim>& solid, const ParticleView<Dim>& elements,
                                  const NeighborList& list, const PairMethod<Dim>& method, BlockTotals<Dim>& totals,
                                  VectorField<Dim>& acceleration);

/// acceleration of the fluid += F_b/m_b (c). Returns Σ_b F_b [N; N/m in 2D].
template <int Dim>
Vec<Dim> add_interface_force_on_fluid(const ParticleView<Dim>& fluid, const ParticleView<Dim>& elements,
                                      const NeighborList& list, const PairMethod<Dim>& method, BlockTotals<Dim>& totals,
                                      VectorField<Dim>& acceleration);

/// density_rate of the fluid += (d).
template <int Dim>
void add_interface_continuity(const ParticleView<Dim>& fluid, const ParticleView<Dim>& elements,
                              const NeighborList& list, const PairMethod<Dim>& method, ScalarField& density_rate);

}  // namespace sluice
