// Rules of what acts within the fluid.
#include <fmt/format.h>

#include "engine/scene/rules/rules.hpp"

namespace sluice::rules {
namespace {

/// What a density diffusion of one kind needs beside itself: required if the fluid has that kind and it is on.
template <Effect of>
Decision part_of_diffusion(const Grounds<of>& g, DensityDiffusion kind) {
    if (!g.content.fluid) return fluid_in(g.content);
    const std::string words = fmt::format("density diffusion by {}", long_name_of(kind));
    const bool is_on = g.template has<Effect::density_diffusion>() && g.scene.method.fluid.density_diffusion == kind;
    return is_on ? required(words) : impossible("no " + words);
}

}  // namespace

Decision fluid_pressure(const Grounds<Effect::fluid_pressure>& g) { return fluid_in(g.content); }

Decision artificial_viscosity(const Grounds<Effect::artificial_viscosity>& g) {
    if (g.content.fluid && g.content.viscous) return impossible("the fluid has a viscosity of its own");
    return by_constant(fluid_in(g.content), "alpha", g.scene.method.fluid.artificial_viscosity, 0);
}

Decision laminar_viscosity(const Grounds<Effect::laminar_viscosity>& g) {
    if (!g.content.fluid) return fluid_in(g.content);
    if (!g.content.viscous) return impossible("viscosity = 0");
    return used(
        fmt::format("the fluid's viscosity, in the form of {}", long_name_of(g.scene.method.fluid.viscous_form)));
}

Decision acoustic_damping(const Grounds<Effect::acoustic_damping>& g) {
    return by_constant(fluid_in(g.content), "alpha", g.scene.method.fluid.acoustic_damping, 0);
}

Decision density_diffusion(const Grounds<Effect::density_diffusion>& g) {
    if (!g.content.fluid) return fluid_in(g.content);
    const DensityDiffusion kind = g.scene.method.fluid.density_diffusion;
    if (kind == DensityDiffusion::none)
        return impossible(fmt::format("method.fluid.density_diffusion = {}", word_of(kind)));
    return used(fmt::format("{}, delta = {}", long_name_of(kind), g.scene.method.fluid.diffusion_coefficient));
}

Decision excess_density(const Grounds<Effect::excess_density>& g) {
    const Decision part = part_of_diffusion(g, DensityDiffusion::fourtakas);
    if (part.is_impossible()) return part;
    return g.content.gravity || g.content.driven ? part : impossible("no gravity");
}

Decision density_gradient(const Grounds<Effect::density_gradient>& g) {
    return part_of_diffusion(g, DensityDiffusion::antuono);
}

Decision particle_shifting(const Grounds<Effect::particle_shifting>& g) {
    return by_constant(fluid_in(g.content), "A", g.scene.method.fluid.shifting, 0);
}

Decision velocity_filter(const Grounds<Effect::velocity_filter>& g) {
    return by_constant(fluid_in(g.content), "theta", g.scene.method.fluid.velocity_filter, 1);
}

Decision several_fluids(const Grounds<Effect::several_fluids>& g) {
    return g.content.fluid ? by_materials(g.content.fluid_materials, "one fluid") : fluid_in(g.content);
}

}  // namespace sluice::rules
