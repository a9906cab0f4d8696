// A solid much lighter than the fluid whose moving boundary it is (kernels/terms/moving_boundary.hpp): what keeps it
// stable. For all other scenes nothing changes.
//
// Added mass. The pressure that fluid exerts contains ρ_f a_s of the solid's last step, so a particle of the solid
// feels −κ ρ_f a_s per volume a step late; κ, the largest eigenvalue of −Σ_f V_f x_sf ⊗ ∇_s W_sf, is ½ at a flat face
// and 1 within the fluid. So a^(n+1) = a_0 − r a^n with r = κ ρ_f/ρ_s, which grows for r > 1 however short the step is
// [Causin, Gerbeau & Nobile 2005]. With a boundary whose acceleration ã follows the solid's,
//   ã^(n+1) = ã^n + β (a^(n+1) − ã^n) = (1 − β (1 + r)) ã^n + β a_0,
// it goes to the same a_0/(1 + r), with β = 1/(1 + ρ_f/ρ_s) without overshoot for every κ of 1 and less. What is slower
// than 1/β steps of the fluid is left as it is.
//
// Sound. Fluid and solid meet by a spring of the fluid's stiffness, ρ_f c_f²/d, and the lighter the solid, the faster
// they vibrate against each other: ω² ~ 1/m_f + 1/m_s, m_f a row of fluid and m_s a plate of two rows, the thinnest
// that there is. The step goes with 1/ω, relative to that of the heaviest solid that is light.
//
// Waves through the thickness. With sub-steps of the solid, the fluid's impulses pump those whose half period is a
// fluid step or less, the more the lighter the solid is. Artificial viscosity damps them; the sound of a light solid is
// so fast that its slow motions do not feel it.
#pragma once

namespace sluice {

struct Scene;
struct Material;

struct LightSolid {
    double relaxation = 1;  ///< β
    double step_share = 1;  ///< of the fluid's largest step
    double viscosity = 0;   ///< α, the least that is good for a total-Lagrangian solid with sub-steps
};

/// Of bodies of this material, beside the heaviest fluid.
LightSolid light_solid(const Scene& scene, const Material& solid);
/// Of the lightest solid.
LightSolid light_solid(const Scene& scene);

/// Raises the solid's artificial viscosity to what a light one needs, unless the scene states it.
void damp_light_solid(Scene& scene);

}  // namespace sluice
