#include "engine/effect_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sluice {
namespace {

using Verdict = Decision::Verdict;

void add_name(std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; }

Decision needs_fluid(const SceneContent& c) {
    return c.fluid ? Decision{Verdict::required, "fluid bodies: " + c.fluids}
                   : Decision{Verdict::impossible, "no fluid body"};
}
/// For what belongs to one of the two descriptions of a solid.
Decision needs_solid(const SceneContent& c, bool described_so, std::string_view other) {
    if (!c.solid) return {Verdict::impossible, "no solid body"};
    if (!described_so) return {Verdict::impossible, fmt::format("the solids are {}", other)};
    return {Verdict::required, "solid bodies: " + c.solids};
}
Decision needs_hypoelastic(const SceneContent& c) { return needs_solid(c, c.hypoelastic, "total Lagrangian"); }
Decision needs_total_lagrangian(const SceneContent& c) { return needs_solid(c, c.total_lagrangian, "hypoelastic"); }

/// Used if its medium is there and its constant differs from the value at which the term vanishes.
Decision by_constant(const Decision& medium, std::string_view symbol, double value, double off_value) {
    if (medium.verdict == Verdict::impossible) return medium;
    return {value != off_value ? Verdict::used : Verdict::impossible, fmt::format("{} = {}", symbol, value)};
}

Decision several(const std::vector<std::string>& materials, std::string_view otherwise) {
    if (materials.size() < 2) return {Verdict::impossible, std::string(otherwise)};
    return {Verdict::required, fmt::format("materials: {}", fmt::join(materials, ", "))};
}

bool is_switched_off(const Scene& s, const std::string& key) {
    const auto asked = s.switches.find(key);
    return asked != s.switches.end() && asked->second == Switch::off;
}

Decision meeting(const SceneContent& c, CouplingScheme asked, const Method& method) {
    if (!c.fluid || !c.solid) return {Verdict::impossible, c.fluid ? "no solid body" : "no fluid body"};
    if (asked != method.coupling) return {Verdict::impossible, "method.coupling is another"};
    return {Verdict::required, fmt::format("{} can meet {}", c.fluids, c.solids)};
}

/// Whether a clamp holds all of a body: if it is convex and holds the corners of what bounds the body.
bool is_held(const Body& body) {
    if (!body.clamp) return false;
    const Bounds b = body.shape->bounds();
    for (unsigned corner = 0; corner < 8; ++corner) {
        Point p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = corner >> k & 1U ? b.max[k] : b.min[k];
        if (!body.clamp->contains(p)) return false;
    }
    return true;
}

Decision meeting_of_solids(const Scene&, const SceneContent& c) {
    if (!c.solid) return {Verdict::impossible, "no solid body"};
    if (!c.movable) return {Verdict::impossible, "all solid bodies are clamped"};
    const std::string walls = c.mirrors + (c.mirrors.empty() || c.fixed_walls.empty() ? "" : ", ") + c.fixed_walls;
    if (!c.total_lagrangian) {
        if (walls.empty()) return {Verdict::impossible, "no wall, and the solids are hypoelastic"};
        return {Verdict::unused, "the solids are hypoelastic; they could meet walls: " + walls};
    }
    if (c.total_lagrangian_bodies < 2 && !c.hypoelastic && walls.empty()) return {Verdict::impossible, "one solid body and no wall"};
    if (walls.empty()) return {Verdict::used, fmt::format("solid bodies: {}", c.solids)};
    return {Verdict::used, fmt::format("solid bodies: {}; walls: {}", c.solids, walls)};
}

/// Whether solids feel walls.
bool solids_meet_walls(const Scene& s, const SceneContent& c) {
    const Verdict verdict = meeting_of_solids(s, c).verdict;
    const auto asked = s.switches.find("contact");
    const Switch wish = asked == s.switches.end() ? Switch::automatic : asked->second;
    return wish == Switch::automatic ? verdict == Verdict::used : wish == Switch::on;
}

// Columns.
constexpr std::string_view fluid_columns =
    "fluid.position fluid.velocity fluid.acceleration fluid.density fluid.density_rate fluid.pressure fluid.mass "
    "fluid.smoothing_length fluid.id fluid.body fluid.pressure_over_rho2";
#define SLUICE_SOLID_COLUMNS                                                                    \
    "solid.position solid.velocity solid.acceleration solid.density solid.pressure solid.mass " \
    "solid.smoothing_length solid.id solid.body solid.clamped "
constexpr std::string_view hypoelastic_columns =
    SLUICE_SOLID_COLUMNS "solid.density_rate solid.deviatoric_stress solid.stress_over_rho2 solid.velocity_gradient";
constexpr std::string_view total_lagrangian_columns = SLUICE_SOLID_COLUMNS
    "solid.reference_position solid.volume solid.deformation solid.corrected_stress solid.gradient_correction "
    "solid.hourglass_stiffness";
#undef SLUICE_SOLID_COLUMNS
constexpr std::string_view element_columns =
    "elements.position elements.area_normal elements.velocity elements.pressure elements.image_pressure "
    "elements.solid_weight elements.force elements.shared_force elements.smoothing_length elements.body "
    "solid.interface_acceleration solid.halfway_position solid.mean_velocity";
constexpr std::string_view boundary_columns =
    "boundary.position boundary.velocity boundary.mean_acceleration boundary.volume boundary.smoothing_length "
    "boundary.force boundary.solid_id boundary.body solid.interface_acceleration solid.halfway_position "
    "solid.mean_velocity solid.mean_acceleration";
constexpr std::string_view wall_columns =
    "wall.position wall.pressure wall.volume wall.smoothing_length wall.id wall.body";

const std::array<EffectRow, effect_count> table{{
    {{Effect::fluid_pressure, "fluid_pressure", "fluid: continuity, pressure, equation of state",
      "Antoci2007 eqs. 4, 8, 10; Monaghan1994", fluid_columns, "on if there is a fluid; cannot be left out",
      "dρ_i/dt = Σ_j m_j v_ij·∇_i W_ij;  a_i = −Σ_j m_j (p_i/ρ_i² + p_j/ρ_j²) ∇_i W_ij;  p = ρ0 c0²/γ ((ρ/ρ0)^γ − 1), "
      "linear: γ = 1",
      "fluid momentum/fluid momentum, fluid density/fluid continuity, update"},
     [](const Scene&, const SceneContent& c) { return needs_fluid(c); },
     {StepPhase::fluid_pass, StepPhase::density_pass}},
    {{Effect::artificial_viscosity, "artificial_viscosity", "fluid: artificial viscosity", "Antoci2007 eq. 12", "",
      "on if method.fluid.artificial_viscosity is not 0 and the fluid has no viscosity of its own",
      "a_i = −Σ_j m_j Π_ij ∇_i W_ij,  Π_ij = −α c0 h min(v_ij·x_ij, 0)/(ρ̄_ij (|x_ij|² + (0.1 h)²))",
      "fluid momentum/fluid momentum"},
     [](const Scene& s, const SceneContent& c) {
         if (c.fluid && c.viscous) return Decision{Verdict::impossible, "the fluid has a viscosity of its own"};
         return by_constant(needs_fluid(c), "alpha", s.method.fluid.artificial_viscosity, 0);
     }},
    {{Effect::laminar_viscosity, "laminar_viscosity", "fluid: viscosity", "Morris1997 eq. 22; Monaghan2005 sect. 8.3",
      "", "on if the fluid's viscosity is above 0",
      "a_i = Σ_j m_j (μ_i + μ_j)/(ρ_i ρ_j) (x_ij·∇_i W_ij)/|x_ij|² v_ij, or Σ_j m_j 2(D + 2) ν v_ij·x_ij/(ρ̄_ij "
      "|x_ij|²) ∇_i W_ij",
      "fluid momentum/fluid momentum"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid) return needs_fluid(c);
         if (!c.viscous) return Decision{Verdict::impossible, "viscosity = 0"};
         return Decision{Verdict::used, s.method.fluid.viscous_form == Viscosity::morris
                                            ? "the fluid's viscosity, in the form of Morris et al."
                                            : "the fluid's viscosity, in the form of Monaghan and Gingold"};
     }},
    {{Effect::acoustic_damping, "acoustic_damping", "fluid: damping of sound by a bulk viscosity",
      "Sun2023; engine/step/material_update.hpp", "", "on if method.fluid.acoustic_damping is not 0",
      "p ← p + α c0 h dρ/dt", "update"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_fluid(c), "alpha", s.method.fluid.acoustic_damping, 0);
     }},
    {{Effect::density_diffusion, "density_diffusion", "fluid: density diffusion",
      "Molteni2009; Fourtakas2019; Antuono2010", "", "on if method.fluid.density_diffusion is not \"none\"",
      "dρ_i/dt += δ c0 Σ_j h_ij V_j Ψ_ij·∇_i W_ij,  Ψ_ij = 2 (ρ_j − ρ_i − E_ij) x_ji/|x_ij|²",
      "fluid density/fluid continuity"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid) return needs_fluid(c);
         constexpr const char* names[] = {"none", "Molteni and Colagrossi", "Fourtakas et al.", "Antuono et al."};
         const DensityDiffusion kind = s.method.fluid.density_diffusion;
         if (kind == DensityDiffusion::none)
             return Decision{Verdict::impossible, "method.fluid.density_diffusion = none"};
         return Decision{Verdict::used, fmt::format("{}, delta = {}", names[static_cast<std::size_t>(kind)],
                                                    s.method.fluid.diffusion_coefficient)};
     }},
    {{Effect::excess_density, "excess_density", "fluid: density less its hydrostatic part", "Fourtakas2019",
      "fluid.excess_density",
      "on if density diffusion is that of Fourtakas and there is gravity or an acceleration; cannot be left out then",
      "ρ − ρ0 g·x/c0²", "fluid density, fluid density/fluid continuity"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid) return needs_fluid(c);
         if (s.method.fluid.density_diffusion != DensityDiffusion::fourtakas || is_switched_off(s, "density_diffusion"))
             return Decision{Verdict::impossible, "no density diffusion by Fourtakas et al."};
         if (!c.gravity && !c.driven) return Decision{Verdict::impossible, "no gravity"};
         return Decision{Verdict::required, "density diffusion by Fourtakas et al."};
     }},
    {{Effect::density_gradient, "density_gradient", "fluid: consistent density gradient", "Antuono2010",
      "fluid.density_gradient", "on if density diffusion is that of Antuono; cannot be left out then",
      "⟨∇ρ⟩_i = M_i⁻¹ Σ_j V_j (ρ_j − ρ_i) ∇_i W_ij,  M_i = Σ_j V_j (x_j − x_i) ⊗ ∇_i W_ij",
      "fluid density, fluid density/density gradient"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid) return needs_fluid(c);
         if (s.method.fluid.density_diffusion != DensityDiffusion::antuono || is_switched_off(s, "density_diffusion"))
             return Decision{Verdict::impossible, "no density diffusion by Antuono et al."};
         return Decision{Verdict::required, "density diffusion by Antuono et al."};
     }},
    {{Effect::particle_shifting, "particle_shifting", "fluid: particle shifting, free surface detected",
      "Lind2012; Skillen2013; Lee2008",
      "fluid.concentration_gradient fluid.surface_normal fluid.position_divergence fluid.concentration "
      "fluid.surface_volume",
      "on if method.fluid.particle_shifting is not 0",
      "δx_i = −A h |v_i| Δt ∇C_i,  ∇C_i = Σ_j V_j (1 + R (W_ij/W(d))⁴) ∇_i W_ij; near a free surface only along it",
      "particle shifting/*"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_fluid(c), "A", s.method.fluid.shifting, 0);
     }},
    {{Effect::velocity_filter, "velocity_filter", "fluid: velocity filter", "Antoci2007 eq. 16",
      "fluid.velocity_correction", "on if method.fluid.velocity_filter is not 1",
      "v_i += (1 − θ) Σ_j V_j (v_j − v_i) W_ij / Σ_j V_j W_ij,  V_j = m_j/ρ̄_ij", "velocity filter/*"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_fluid(c), "theta", s.method.fluid.velocity_filter, 1);
     }},
    {{Effect::several_fluids, "several_fluids", "fluid: pairs across different fluids",
      "Colagrossi2003; Hu2006; kernels/terms/multiphase.hpp",
      "fluid.rest_density fluid.sound_speed fluid.excess_density",
      "on if fluid bodies have different materials; cannot be left out then",
      "a_i = −Σ_j m_j (p_i + p_j)/(ρ_i ρ_j) ∇_i W_ij;  dρ_i/dt = ρ_i Σ_j m_j/ρ_j v_ij·∇_i W_ij",
      "fluid momentum/fluid momentum, fluid density/fluid continuity"},
     [](const Scene&, const SceneContent& c) {
         if (!c.fluid) return needs_fluid(c);
         return several(c.fluid_materials, "one fluid");
     }},
    {{Effect::solid_stress, "solid_stress", "solid: continuity, hypoelastic stress with Jaumann rate",
      "Antoci2007 eqs. 4, 5, 8, 11, 15", hypoelastic_columns,
      "on if a solid has the model \"hypoelastic\"; cannot be left out then",
      "a_i = Σ_j m_j (σ_i/ρ_i² + σ_j/ρ_j²) ∇_i W_ij;  dS/dt = 2μ (D − tr(D)/3 I) + Ω S + S Ωᵀ;  σ = S − c0² (ρ − ρ0) "
      "I",
      "solid momentum/solid momentum, solid gradient and stress/velocity gradient, update"},
     [](const Scene&, const SceneContent& c) { return needs_hypoelastic(c); },
     {StepPhase::solid_pass, StepPhase::gradient_pass}},
    {{Effect::total_lagrangian, "total_lagrangian", "solid: hyperelastic stress in the reference configuration",
      "Vignjevic2006; kernels/passes/total_lagrangian_passes.hpp", total_lagrangian_columns,
      "on if a solid has the model \"st-venant-kirchhoff\" or \"neo-hookean\"; cannot be left out then",
      "f_a = V_a Σ_b V_b (P_a L_a + P_b L_b) ∇_a W_ab,  F_a = Σ_b V_b (x_b − x_a) ⊗ L_a ∇_a W_ab,  P = ∂ψ/∂F",
      "solid momentum/elastic momentum, solid gradient and stress/deformation gradient, update"},
     [](const Scene&, const SceneContent& c) { return needs_total_lagrangian(c); },
     {StepPhase::solid_pass, StepPhase::gradient_pass}},
    {{Effect::hourglass_control, "hourglass_control", "solid: hourglass control", "Ganzenmueller2015; Silling2017", "",
      "on if there is a total-Lagrangian solid and method.solid.hourglass_control is not 0",
      "f_a = −V_a Σ_b V_b w_ab [k_a (x_ab − F_a X_ab) + k_b (x_ab − F_b X_ab)],  k = 2 ζ μ",
      "solid momentum/elastic momentum, solid gradient and stress/deformation gradient"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_total_lagrangian(c), "zeta", s.method.solid.hourglass_control, 0);
     }},
    {{Effect::solid_viscosity, "solid_viscosity", "solid: artificial viscosity", "Antoci2007 eq. 12", "",
      "on if there is a solid and method.solid.artificial_viscosity is not 0",
      "a_i = −Σ_j m_j Π_ij ∇_i W_ij,  Π_ij = −α c0 h min(v_ij·x_ij, 0)/(ρ̄_ij (|x_ij|² + (0.1 h)²)); total Lagrangian: "
      "∇W of X",
      "solid momentum/solid momentum, solid momentum/elastic momentum"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_solid(c, true, ""), "alpha", s.method.solid.artificial_viscosity, 0);
     }},
    {{Effect::artificial_stress, "artificial_stress", "solid: artificial stress", "Antoci2007 eqs. 13, 14",
      "solid.artificial_stress", "on if there is a hypoelastic solid and method.solid.artificial_stress is not 0",
      "a_i = Σ_j m_j (R_i + R_j) f^q ∇_i W_ij,  f = W(|x_ij|)/W(d),  R = Σ_k −e σ_k/ρ² n_k ⊗ n_k over tensions σ_k > "
      "0",
      "solid momentum/solid momentum, update"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_hypoelastic(c), "e", s.method.solid.artificial_stress, 0);
     }},
    {{Effect::solid_filter, "solid_filter", "solid: velocity filter", "Antoci2007 eq. 16", "solid.velocity_correction",
      "on if there is a hypoelastic solid and method.solid.velocity_filter is not 1",
      "v_i += (1 − θ) Σ_j V_j (v_j − v_i) W_ij / Σ_j V_j W_ij,  V_j = m_j/ρ̄_ij", "velocity filter/*"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_hypoelastic(c), "theta", s.method.solid.velocity_filter, 1);
     }},
    {{Effect::several_solids, "several_solids", "solid: pairs across different solids",
      "kernels/terms/multiphase.hpp", "solid.rest_density solid.sound_speed",
      "on if solid bodies have different materials; cannot be left out then",
      "a_i = Σ_j m_j (σ_i + σ_j)/(ρ_i ρ_j) ∇_i W_ij;  dρ_i/dt = ρ_i Σ_j m_j/ρ_j v_ij·∇_i W_ij;  viscosity by the mean c0",
      "solid momentum/solid momentum, solid momentum/elastic momentum, solid gradient and stress/velocity gradient"},
     [](const Scene&, const SceneContent& c) {
         if (!c.solid) return needs_solid(c, true, "");
         return several(c.solid_materials, "one solid material");
     }},
    {{Effect::contact, "contact", "solid: contact with other solids and with walls, without friction",
      "kernels/passes/contact_passes.hpp", wall_columns,
      "on if there are two total-Lagrangian bodies, or one and a wall, and not all are clamped; may be switched on for "
      "hypoelastic solids and walls",
      "f_i = −V_i Σ_j V_j (p_i + p_j) ∇W_ij,  p = k (σ − σ_0)₊,  σ_i = Σ_j V_j W_ij,  j of other bodies", "contact/*"},
     meeting_of_solids},
    {{Effect::interface_force, "interface_force", "coupling: interface force, reaction, kinematic condition",
      "Antoci2007 eqs. 24-30", element_columns,
      "on if there are a fluid and a solid and method.coupling is \"interface-force\"; cannot be left out then",
      "p_k = 2 Σ_b V_b p_b W_kb;  f_k = −p_k n_k ΔΓ_k;  dρ_b/dt = −2 ρ_b Σ_k W_kb n_k ΔΓ_k·(v_b − v_k)", "interface/*"},
     [](const Scene& s, const SceneContent& c) { return meeting(c, CouplingScheme::interface_force, s.method); },
     {StepPhase::interface_pass}},
    {{Effect::moving_boundary, "moving_boundary", "coupling: the solid's particles as moving boundary of the fluid",
      "Adami2012 eq. 25; Zhang2021; kernels/terms/moving_boundary.hpp", boundary_columns,
      "on if there are a fluid and a solid and method.coupling is \"moving-boundary\"; cannot be left out then",
      "F_fs = −V_f V_s max(p_f + p_s, 0) ∇_f W_fs = −F_sf,  p_s = p_f + ρ_f (g − a_s)·(x_s − x_f);  dρ_f/dt = ρ_f Σ_s "
      "V_s (v_f − v_s)·∇_f W_fs",
      "interface, interface/boundary force, interface/boundary reaction, interface/boundary continuity, "
      "particle shifting/boundary concentration"},
     [](const Scene& s, const SceneContent& c) { return meeting(c, CouplingScheme::moving_boundary, s.method); },
     {StepPhase::interface_pass}},
    {{Effect::mirror_wall, "mirror_wall", "walls: mirrored ghosts (slip)", "Antoci2007 sect. 4", "",
      "on if there are a fluid and a mirror wall; cannot be left out then",
      "x' = x − 2 ((x − P)·n) n,  v' = v − 2 (v·n) n,  scalars copied"},
     [](const Scene&, const SceneContent& c) {
         if (!c.mirror) return Decision{Verdict::impossible, "no mirror wall"};
         return c.fluid ? Decision{Verdict::required, "walls: " + c.mirrors}
                        : Decision{Verdict::impossible, "no fluid body to mirror"};
     }},
    {{Effect::fixed_wall, "fixed_wall", "walls: layers of fixed ghosts", "Antoci2007 sect. 4; Adami2012 eq. 27",
      wall_columns, "on if there are a fluid and a fixed wall; cannot be left out then",
      "p_w = max(0, Σ_f V_f (p_f + ρ_f (g − a_w)·(x_w − x_f)) W_wf / Σ_f V_f W_wf);  a_i = −1/ρ_i Σ_j V_j (p_i + p_j) "
      "∇_i W_ij;  dρ_i/dt = ρ_i Σ_j V_j (v_i − v_j)·∇_i W_ij",
      "walls and images, walls and images/ghost pressure, walls and images/ghost force, walls and images/ghost "
      "continuity, walls and images/boundary continuity, particle shifting/boundary concentration"},
     [](const Scene&, const SceneContent& c) {
         if (!c.fixed) return Decision{Verdict::impossible, "no fixed wall"};
         return c.fluid ? Decision{Verdict::required, "walls: " + c.fixed_walls}
                        : Decision{Verdict::impossible, "no fluid body to hold"};
     },
     {StepPhase::wall_pass}},
    {{Effect::no_slip_wall, "no_slip_wall", "walls: no slip", "Adami2012 eqs. 22, 23; Morris1997",
      "wall.ghost_velocity wall.friction_volume",
      "on if a fixed wall has condition = \"no-slip\" and the fluid's viscosity is above 0",
      "v_g = 2 v_w − Σ_f V_f v_f W_wf/Σ_f V_f W_wf;  a_f = 2 ν Σ_w V_w (∂W/∂r / r) (v_f − v_g)",
      "walls and images/ghost velocity, walls and images/boundary friction"},
     [](const Scene&, const SceneContent& c) {
         if (!c.no_slip) return Decision{Verdict::impossible, "no wall with condition = \"no-slip\""};
         return c.viscous ? Decision{Verdict::used, "walls: " + c.no_slip_walls}
                          : Decision{Verdict::impossible, "viscosity = 0"};
     }},
    {{Effect::no_slip_solid, "no_slip_solid", "coupling: no slip", "Adami2012 eqs. 22, 23; Morris1997",
      "boundary.ghost_velocity", "on if solids are a moving boundary and the fluid's viscosity is above 0",
      "v_g = 2 v_s − Σ_f V_f v_f W_sf/Σ_f V_f W_sf;  F_fs = 2 ν m_f V_s (∂W/∂r / r) (v_f − v_g) = −F_sf",
      "interface/ghost velocity, interface/boundary friction, interface/friction reaction"},
     [](const Scene& s, const SceneContent& c) {
         const Decision d = meeting(c, CouplingScheme::moving_boundary, s.method);
         if (d.verdict == Verdict::impossible) return d;
         return c.viscous ? Decision{Verdict::used, "a viscous fluid sticks to solids"}
                          : Decision{Verdict::impossible, "viscosity = 0"};
     }},
    {{Effect::moving_wall, "moving_wall", "walls: motion by formula or table", "Adami2012 eq. 25",
      "wall.initial_position wall.velocity",
      "on if there are a wall with a motion and a fluid, or solids that touch walls (contact)",
      "x(t) = x(0) + u(t),  v = (x(t + Δt) − x(t))/Δt",
      "walls and images, walls and images/boundary continuity, walls and images/ghost pressure"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.moving_wall) return Decision{Verdict::impossible, "no wall with a motion"};
         return c.fluid || solids_meet_walls(s, c) ? Decision{Verdict::used, "walls: " + c.moving_walls}
                                                   : Decision{Verdict::impossible, "no fluid body to move"};
     }},
    {{Effect::periodic_box, "periodic_box", "walls: periodic box", "engine/particles/ghosts.hpp", "",
      "on if there are a fluid and a periodic axis; cannot be left out then", "x' = x ± L,  all else copied"},
     [](const Scene&, const SceneContent& c) {
         if (c.periodic_axes.empty()) return Decision{Verdict::impossible, "no periodic axis"};
         return c.fluid ? Decision{Verdict::required, "along " + c.periodic_axes}
                        : Decision{Verdict::impossible, "no fluid body"};
     }},
    {{Effect::clamp, "clamp", "solid: clamp", "Antoci2007 sect. 4", "",
      "on if a body has a clamp; cannot be left out then", "v = 0"},
     [](const Scene&, const SceneContent& c) {
         return c.clamp ? Decision{Verdict::required, "bodies: " + c.clamps}
                        : Decision{Verdict::impossible, "no clamped body"};
     }},
    {{Effect::clamp_extension, "clamp_extension", "solid: displacement goes on behind a clamp's surface",
      "engine/parts/clamp_extension.hpp", "solid.elastic_share", "on if a total-Lagrangian body has a clamp",
      "u(X_b) = −r u(X_j),  r = |X_b − X_s|/|X_j − X_s|;  V ψ and k times the cell's share outside the clamp",
      "solid momentum, solid gradient and stress"},
     [](const Scene&, const SceneContent& c) {
         const Decision d = needs_total_lagrangian(c);
         if (d.verdict == Verdict::impossible) return d;
         return c.clamp ? Decision{Verdict::used, "bodies: " + c.clamps}
                        : Decision{Verdict::impossible, "no clamped body"};
     }},
    {{Effect::gravity, "gravity", "gravity", "Antoci2007 eq. 2", "", "on if gravity is not 0", "a += g"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.gravity) return Decision{Verdict::impossible, "gravity = 0"};
         return Decision{Verdict::used, fmt::format("g = ({}, {}, {}) m/s2", s.gravity[0], s.gravity[1], s.gravity[2])};
     }},
    {{Effect::driven_acceleration, "driven_acceleration", "acceleration that depends on time",
      "engine/step/body_acceleration.hpp", "", "on if the scene states an acceleration", "a += a(t)"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.driven) return Decision{Verdict::impossible, "no acceleration in the scene"};
         return Decision{Verdict::used, fmt::format("a(t) = ({}) m/s2", fmt::join(s.acceleration, ", "))};
     }},
    {{Effect::variable_resolution, "variable_resolution", "pairs of unequal size: mean smoothing length",
      "kernels/pairs/pair.hpp", "", "on if bodies have different spacings; cannot be left out then", "h_ij = (h_i + h_j)/2"},
     [](const Scene&, const SceneContent& c) {
         return c.many_spacings ? Decision{Verdict::required, "bodies of different spacing"}
                                : Decision{Verdict::impossible, "one spacing"};
     }},
    {{Effect::adaptive_step, "adaptive_step", "time: steps that follow speed and acceleration",
      "Monaghan1992; engine/step/step_plan.hpp", "",
      "on if method.step_size is \"adaptive\" and method.time_step is not stated",
      "Δt = min(C h/(c0 + |v|), ¼ √(h/|a|)), growing by a tenth per step at the most"},
     [](const Scene& s, const SceneContent&) {
         if (s.method.time_step) return Decision{Verdict::impossible, "method.time_step states it"};
         return s.method.step_size == StepSize::adaptive ? Decision{Verdict::used, "method.step_size"}
                                                         : Decision{Verdict::unused, "method.step_size = \"fixed\""};
     }},
    {{Effect::solid_substeps, "solid_substeps", "time: the solid at its own rate", "engine/step/step_plan.hpp", "",
      "on if there are a fluid and a solid and method.time_stepping is \"multi-rate\"",
      "n = ⌈Δt/Δt_solid⌉ steps of Δt/n"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid || !c.solid) return Decision{Verdict::impossible, "one medium"};
         return s.method.multi_rate ? Decision{Verdict::used, "method.time_stepping"}
                                    : Decision{Verdict::unused, "method.time_stepping = \"single-rate\""};
     }},
    {{Effect::steady_load, "steady_load", "time: the steady part of the load acts within the solid's steps",
      "engine/parts/steady_load.hpp", "solid.steady_acceleration",
      "on if water meets total-Lagrangian solids that go at their own rate",
      "f̄^n = f̄^(n−1) + (f^n − f̄^(n−1))/32 all the time, ½Δt (f^n − f̄^n) and ½Δt (f^(n+1) − f̄^n) as impulses", "update"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid || !c.solid) return Decision{Verdict::impossible, "one medium"};
         if (!c.total_lagrangian) return Decision{Verdict::impossible, "the solids are hypoelastic"};
         if (!s.method.multi_rate || is_switched_off(s, "solid_substeps"))
             return Decision{Verdict::impossible, "the solid has no steps of its own"};
         return Decision{Verdict::used, fmt::format("load of {} on {}", c.fluids, c.solids)};
     }},
}};

}  // namespace

SceneContent content_of(const Scene& scene) {
    SceneContent c;
    double smallest = 1e300, largest = 0;
    for (const Body& body : scene.bodies) {
        const bool is_fluid = scene.materials[body.material].kind == MaterialKind::fluid;
        (is_fluid ? c.fluid : c.solid) = true;
        if (is_fluid && scene.materials[body.material].viscosity > 0) c.viscous = true;
        if (!is_fluid) {
            const bool in_rates = scene.materials[body.material].model == SolidModel::hypoelastic;
            (in_rates ? c.hypoelastic : c.total_lagrangian) = true;
            c.total_lagrangian_bodies += in_rates ? 0 : 1;
        }
        add_name(is_fluid ? c.fluids : c.solids, body.name);
        auto& materials = is_fluid ? c.fluid_materials : c.solid_materials;
        const std::string& material = scene.materials[body.material].name;
        if (std::find(materials.begin(), materials.end(), material) == materials.end()) materials.push_back(material);
        if (!is_fluid && !is_held(body)) c.movable = true;
        if (body.clamp) c.clamp = true, add_name(c.clamps, body.name);
        smallest = std::min(smallest, body.spacing);
        largest = std::max(largest, body.spacing);
    }
    c.many_spacings = largest > smallest * (1 + 1e-9);
    for (const Wall& wall : scene.walls) {
        (wall.kind == WallKind::mirror ? c.mirror : c.fixed) = true;
        if (!wall.slip) c.no_slip = true, add_name(c.no_slip_walls, wall.name);
        if (wall.motion.moves()) c.moving_wall = true, add_name(c.moving_walls, wall.name);
        add_name(wall.kind == WallKind::mirror ? c.mirrors : c.fixed_walls, wall.name);
    }
    for (std::size_t k = 0; k < 3; ++k)
        if (scene.periodic[k]) add_name(c.periodic_axes, std::string(1, "xyz"[k]));
    c.driven = scene.acceleration != std::array<Formula, 3>{};
    c.gravity = std::any_of(scene.gravity.begin(), scene.gravity.end(), [](double g) { return g != 0; });
    return c;
}

std::span<const EffectRow> effect_table() { return table; }

}  // namespace sluice
