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

bool is_switched_off(const Scene& s, const std::string& key) {
    const auto asked = s.switches.find(key);
    return asked != s.switches.end() && asked->second == Switch::off;
}

Decision meeting(const SceneContent& c, Coupling asked, const Method& method) {
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
    if (c.total_lagrangian_bodies < 2 && walls.empty()) return {Verdict::impossible, "one solid body and no wall"};
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
    "boundary.position boundary.velocity boundary.acceleration boundary.volume boundary.smoothing_length "
    "boundary.force boundary.solid boundary.body solid.interface_acceleration solid.halfway_position "
    "solid.mean_velocity solid.mean_acceleration";
constexpr std::string_view wall_columns =
    "wall.position wall.pressure wall.volume wall.smoothing_length wall.id wall.body";

const std::array<EffectRow, effect_count> table{{
    {{Effect::fluid_pressure, "fluid_pressure", "fluid: continuity, pressure, linear equation of state",
      "Antoci2007 eqs. 4, 8, 10", fluid_columns},
     [](const Scene&, const SceneContent& c) { return needs_fluid(c); },
     {StepPhase::fluid_pass, StepPhase::density_pass}},
    {{Effect::artificial_viscosity, "artificial_viscosity", "fluid: artificial viscosity", "Antoci2007 eq. 12", ""},
     [](const Scene& s, const SceneContent& c) {
         if (c.fluid && c.viscous) return Decision{Verdict::impossible, "the fluid has a viscosity of its own"};
         return by_constant(needs_fluid(c), "alpha", s.method.fluid.artificial_viscosity, 0);
     }},
    {{Effect::laminar_viscosity, "laminar_viscosity", "fluid: viscosity", "Morris1997 eq. 22; Monaghan2005 sect. 8.3",
      ""},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid) return needs_fluid(c);
         if (!c.viscous) return Decision{Verdict::impossible, "viscosity = 0"};
         return Decision{Verdict::used, s.method.fluid.viscous_form == Viscosity::morris
                                            ? "the fluid's viscosity, in the form of Morris et al."
                                            : "the fluid's viscosity, in the form of Monaghan and Gingold"};
     }},
    {{Effect::acoustic_damping, "acoustic_damping", "fluid: damping of sound by a bulk viscosity",
      "Sun2023; engine/step/material_update.hpp", ""},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_fluid(c), "alpha", s.method.fluid.acoustic_damping, 0);
     }},
    {{Effect::density_diffusion, "density_diffusion", "fluid: density diffusion",
      "Molteni2009; Fourtakas2019; Antuono2010", ""},
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
      "fluid.excess_density"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid) return needs_fluid(c);
         if (s.method.fluid.density_diffusion != DensityDiffusion::fourtakas || is_switched_off(s, "density_diffusion"))
             return Decision{Verdict::impossible, "no density diffusion by Fourtakas et al."};
         if (!c.gravity && !c.driven) return Decision{Verdict::impossible, "no gravity"};
         return Decision{Verdict::required, "density diffusion by Fourtakas et al."};
     }},
    {{Effect::density_gradient, "density_gradient", "fluid: consistent density gradient", "Antuono2010",
      "fluid.density_gradient"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid) return needs_fluid(c);
         if (s.method.fluid.density_diffusion != DensityDiffusion::antuono || is_switched_off(s, "density_diffusion"))
             return Decision{Verdict::impossible, "no density diffusion by Antuono et al."};
         return Decision{Verdict::required, "density diffusion by Antuono et al."};
     }},
    {{Effect::particle_shifting, "particle_shifting", "fluid: particle shifting, free surface detected",
      "Lind2012; Skillen2013; Lee2008",
      "fluid.concentration_gradient fluid.surface_normal fluid.position_divergence fluid.concentration "
      "fluid.surface_volume"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_fluid(c), "A", s.method.fluid.shifting, 0);
     }},
    {{Effect::velocity_filter, "velocity_filter", "fluid: velocity filter", "Antoci2007 eq. 16",
      "fluid.velocity_correction"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_fluid(c), "theta", s.method.fluid.velocity_filter, 1);
     }},
    {{Effect::solid_stress, "solid_stress", "solid: continuity, hypoelastic stress with Jaumann rate",
      "Antoci2007 eqs. 4, 5, 8, 11, 15", hypoelastic_columns},
     [](const Scene&, const SceneContent& c) { return needs_hypoelastic(c); },
     {StepPhase::solid_pass, StepPhase::gradient_pass}},
    {{Effect::total_lagrangian, "total_lagrangian", "solid: hyperelastic stress in the reference configuration",
      "Vignjevic2006; kernels/total_lagrangian_passes.hpp", total_lagrangian_columns},
     [](const Scene&, const SceneContent& c) { return needs_total_lagrangian(c); },
     {StepPhase::solid_pass, StepPhase::gradient_pass}},
    {{Effect::hourglass_control, "hourglass_control", "solid: hourglass control", "Ganzenmueller2015; Silling2017", ""},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_total_lagrangian(c), "zeta", s.method.solid.hourglass_control, 0);
     }},
    {{Effect::solid_viscosity, "solid_viscosity", "solid: artificial viscosity", "Antoci2007 eq. 12", ""},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_solid(c, true, ""), "alpha", s.method.solid.artificial_viscosity, 0);
     }},
    {{Effect::artificial_stress, "artificial_stress", "solid: artificial stress", "Antoci2007 eqs. 13, 14",
      "solid.artificial_stress"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_hypoelastic(c), "e", s.method.solid.artificial_stress, 0);
     }},
    {{Effect::solid_filter, "solid_filter", "solid: velocity filter", "Antoci2007 eq. 16", "solid.velocity_correction"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_hypoelastic(c), "theta", s.method.solid.velocity_filter, 1);
     }},
    {{Effect::contact, "contact", "solid: contact with other solids and with walls, without friction",
      "kernels/contact_passes.hpp", wall_columns},
     meeting_of_solids},
    {{Effect::interface_force, "interface_force", "coupling: interface force, reaction, kinematic condition",
      "Antoci2007 eqs. 24-30", element_columns},
     [](const Scene& s, const SceneContent& c) { return meeting(c, Coupling::interface_force, s.method); },
     {StepPhase::interface_pass}},
    {{Effect::moving_boundary, "moving_boundary", "coupling: the solid's particles as moving boundary of the fluid",
      "Adami2012 eq. 25; Zhang2021; kernels/terms/moving_boundary.hpp", boundary_columns},
     [](const Scene& s, const SceneContent& c) { return meeting(c, Coupling::moving_boundary, s.method); },
     {StepPhase::interface_pass}},
    {{Effect::mirror_wall, "mirror_wall", "walls: mirrored ghosts (slip)", "Antoci2007 sect. 4", ""},
     [](const Scene&, const SceneContent& c) {
         if (!c.mirror) return Decision{Verdict::impossible, "no mirror wall"};
         return c.fluid ? Decision{Verdict::required, "walls: " + c.mirrors}
                        : Decision{Verdict::impossible, "no fluid body to mirror"};
     }},
    {{Effect::fixed_wall, "fixed_wall", "walls: layers of fixed ghosts", "Antoci2007 sect. 4; Adami2012 eq. 27",
      wall_columns},
     [](const Scene&, const SceneContent& c) {
         if (!c.fixed) return Decision{Verdict::impossible, "no fixed wall"};
         return c.fluid ? Decision{Verdict::required, "walls: " + c.fixed_walls}
                        : Decision{Verdict::impossible, "no fluid body to hold"};
     },
     {StepPhase::wall_pass}},
    {{Effect::no_slip_wall, "no_slip_wall", "walls: no slip", "Adami2012 eqs. 22, 23; Morris1997",
      "wall.ghost_velocity wall.friction_volume"},
     [](const Scene&, const SceneContent& c) {
         if (!c.no_slip) return Decision{Verdict::impossible, "no wall with condition = \"no-slip\""};
         return c.viscous ? Decision{Verdict::used, "walls: " + c.no_slip_walls}
                          : Decision{Verdict::impossible, "viscosity = 0"};
     }},
    {{Effect::no_slip_solid, "no_slip_solid", "coupling: no slip", "Adami2012 eqs. 22, 23; Morris1997",
      "boundary.ghost_velocity"},
     [](const Scene& s, const SceneContent& c) {
         const Decision d = meeting(c, Coupling::moving_boundary, s.method);
         if (d.verdict == Verdict::impossible) return d;
         return c.viscous ? Decision{Verdict::used, "a viscous fluid sticks to solids"}
                          : Decision{Verdict::impossible, "viscosity = 0"};
     }},
    {{Effect::moving_wall, "moving_wall", "walls: motion by formula or table", "Adami2012 eq. 25",
      "wall.initial_position wall.velocity"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.moving_wall) return Decision{Verdict::impossible, "no wall with a motion"};
         return c.fluid || solids_meet_walls(s, c) ? Decision{Verdict::used, "walls: " + c.moving_walls}
                                                   : Decision{Verdict::impossible, "no fluid body to move"};
     }},
    {{Effect::periodic_box, "periodic_box", "walls: periodic box", "engine/state/images.hpp", ""},
     [](const Scene&, const SceneContent& c) {
         if (c.periodic_axes.empty()) return Decision{Verdict::impossible, "no periodic axis"};
         return c.fluid ? Decision{Verdict::required, "along " + c.periodic_axes}
                        : Decision{Verdict::impossible, "no fluid body"};
     }},
    {{Effect::clamp, "clamp", "solid: clamp", "Antoci2007 sect. 4", ""},
     [](const Scene&, const SceneContent& c) {
         return c.clamp ? Decision{Verdict::required, "bodies: " + c.clamps}
                        : Decision{Verdict::impossible, "no clamped body"};
     }},
    {{Effect::gravity, "gravity", "gravity", "Antoci2007 eq. 2", ""},
     [](const Scene& s, const SceneContent& c) {
         if (!c.gravity) return Decision{Verdict::impossible, "gravity = 0"};
         return Decision{Verdict::used, fmt::format("g = ({}, {}, {}) m/s2", s.gravity[0], s.gravity[1], s.gravity[2])};
     }},
    {{Effect::driven_acceleration, "driven_acceleration", "acceleration that depends on time",
      "engine/step/body_acceleration.hpp", ""},
     [](const Scene& s, const SceneContent& c) {
         if (!c.driven) return Decision{Verdict::impossible, "no acceleration in the scene"};
         return Decision{Verdict::used, fmt::format("a(t) = ({}) m/s2", fmt::join(s.acceleration, ", "))};
     }},
    {{Effect::variable_resolution, "variable_resolution", "pairs of unequal size: mean smoothing length",
      "kernels/pair.hpp", ""},
     [](const Scene&, const SceneContent& c) {
         return c.many_spacings ? Decision{Verdict::required, "bodies of different spacing"}
                                : Decision{Verdict::impossible, "one spacing"};
     }},
    {{Effect::adaptive_step, "adaptive_step", "time: steps that follow speed and acceleration",
      "Monaghan1992; engine/step/step_plan.hpp", ""},
     [](const Scene& s, const SceneContent&) {
         if (s.method.time_step) return Decision{Verdict::impossible, "method.time_step states it"};
         return s.method.step_size == StepSize::adaptive ? Decision{Verdict::used, "method.step_size"}
                                                         : Decision{Verdict::unused, "method.step_size = \"fixed\""};
     }},
    {{Effect::solid_substeps, "solid_substeps", "time: the solid at its own rate", "engine/step/step_plan.hpp", ""},
     [](const Scene& s, const SceneContent& c) {
         if (!c.fluid || !c.solid) return Decision{Verdict::impossible, "one medium"};
         return s.method.multi_rate ? Decision{Verdict::used, "method.time_stepping"}
                                    : Decision{Verdict::unused, "method.time_stepping = \"single-rate\""};
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
