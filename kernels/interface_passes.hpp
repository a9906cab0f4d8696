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
#pragma once

#include <cstdint>

#include "kernels/fluid_passes.hpp"

namespace sluice {

/// Read-only columns of the interface elements; those at index `owned` and beyond are images across mirror walls.
template <int Dim>
struct ElementView {
    std::array<const double*, Dim> position{};     ///< [m]
    std::array<const double*, Dim> area_normal{};  ///< n ΔΓ into the fluid [m²; m in 2D]
    std::array<const double*, Dim> velocity{};     ///< of the solid [m/s]
    std::size_t owned = 0;
};

/// All lists here have groups of one.

/// Pressure of owned elements (a), and the part of it that comes from images of fluid particles (index ≥ owned_fluid).
template <int Dim, class Real>
void interface_pressure(const ElementView<Dim>& elements, const ParticleView<Dim>& fluid, std::size_t owned_fluid,
                        const NeighborList& list, ScalarField& pressure, ScalarField& image_pressure);

/// Σ_a V_a W_ka for each owned element, and v_k of (d). An element that its solid has left behind has weight 0; nothing
/// can take up a force on it, so the caller must take its area away.
template <int Dim, class Real>
void interface_weights(const ElementView<Dim>& elements, const ParticleView<Dim>& solid, const NeighborList& list,
                       ScalarField& weight, VectorField<Dim>& velocity);

/// acceleration of the solid += F_a/m_a (b). Returns Σ_a F_a [N; N/m in 2D].
template <int Dim, class Real>
Vec<Dim> interface_force_on_solid(const ParticleView<Dim>& solid, const ElementView<Dim>& elements,
                                  const NeighborList& list, const ScalarField& weight, const VectorField<Dim>& force,
                                  VectorField<Dim>& acceleration);

/// acceleration of the fluid += F_b/m_b (c). Returns the part of Σ_b F_b that owned elements exert [N; N/m in 2D].
template <int Dim, class Real>
Vec<Dim> interface_force_on_fluid(const ParticleView<Dim>& fluid, const ElementView<Dim>& elements,
                                  const NeighborList& list, VectorField<Dim>& acceleration);

/// density_rate of the fluid += (d).
template <int Dim, class Real>
void interface_continuity(const ParticleView<Dim>& fluid, const ElementView<Dim>& elements, const NeighborList& list,
                          ScalarField& density_rate);

}  // namespace sluice
