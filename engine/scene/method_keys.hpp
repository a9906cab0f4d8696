// The keys of [method], each with what it sets: for whatever reads them or tells their values.
#pragma once

#include "engine/scene/scene.hpp"

namespace sluice {

/// `visit(key, member)` for each key of [method] itself, in the order of the table of keys. M is a Method, const or not.
template <class M, class Visit>
void for_each_method_key(M& method, Visit&& visit) {
    visit("preset", method.preset);
    visit("spacing", method.spacing);
    visit("smoothing_function", method.smoothing_function);
    visit("smoothing_length", method.smoothing_length);
    visit("coupling", method.coupling);
    visit("precision", method.precision);
    visit("integrator", method.integrator);
    visit("step_size", method.step_size);
    visit("courant", method.courant);
    visit("time_step", method.time_step);
    visit("time_stepping", method.time_stepping);
    visit("mach_limit", method.mach_limit);
    visit("expected_speed", method.expected_speed);
}

/// The same for [method.fluid].
template <class M, class Visit>
void for_each_fluid_key(M& fluid, Visit&& visit) {
    visit("velocity_filter", fluid.velocity_filter);
    visit("artificial_viscosity", fluid.artificial_viscosity);
    visit("viscous_form", fluid.viscous_form);
    visit("density_diffusion", fluid.density_diffusion);
    visit("acoustic_damping", fluid.acoustic_damping);
    visit("particle_shifting", fluid.shifting);
    visit("diffusion_coefficient", fluid.diffusion_coefficient);
}

/// The same for [method.solid].
template <class M, class Visit>
void for_each_solid_key(M& solid, Visit&& visit) {
    visit("velocity_filter", solid.velocity_filter);
    visit("artificial_viscosity", solid.artificial_viscosity);
    visit("artificial_stress", solid.artificial_stress);
    visit("artificial_stress_exponent", solid.artificial_stress_exponent);
    visit("hourglass_control", solid.hourglass_control);
}

}  // namespace sluice
