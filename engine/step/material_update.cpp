#include "engine/step/material_update.hpp"

#include "kernels/materials/jaumann.hpp"
#include "kernels/materials/tensile_correction.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

template <int Dim>
void set_fluid_pressure(ParticleSet<Dim>& fluid, const EquationOfState& eos, double acoustic_damping, std::size_t i) {
    const double rho = fluid.density[i];
    double p = eos.pressure(rho);
    if (acoustic_damping != 0)
        p += acoustic_damping * eos.sound_speed * fluid.smoothing_length[i] * fluid.density_rate[i];
    fluid.pressure[i] = p;
    fluid.pressure_over_rho2[i] = p / (rho * rho);
}

template <int Dim>
void set_solid_stress(ParticleSet<Dim>& solid, const LinearEquationOfState& eos, double artificial_stress,
                      std::size_t i) {
    const double rho = solid.density[i], p = eos.pressure(rho);
    solid.pressure[i] = p;
    auto s = solid.deviatoric_stress[i];
    for (int k = 0; k < Dim; ++k) s[k] -= p;
    s *= 1 / (rho * rho);
    solid.stress_over_rho2.set(i, s);
    if (artificial_stress != 0) solid.artificial_stress.set(i, tensile_correction(s, artificial_stress));
}

template <int Dim>
void advance_stress(ParticleSet<Dim>& solid, double shear_modulus, double dt, std::size_t i) {
    const Tensor<Dim> gradient = tensor_of<Dim>(solid.velocity_gradient[i]);
    const Tensor<Dim> s = sym_to_tensor<Dim>(solid.deviatoric_stress[i]);
    solid.deviatoric_stress.set(i, tensor_to_sym<Dim>(advance_deviatoric_stress<Dim>(s, gradient, shear_modulus, dt)));
}

template <int Dim>
void advance_position_and_density(ParticleSet<Dim>& phase, double dt, std::size_t i) {
    phase.position.set(i, phase.position[i] + 0.5 * dt * phase.velocity[i]);
    phase.density[i] += dt * phase.density_rate[i];
}

}  // namespace

template <int Dim>
void update_fluid_pressure(State<Dim>& state) {
    auto& fluid = state.fluid;
    if (fluid.owned == 0) return;
    const LinearEquationOfState eos = state.water->eos;
    parallel_for(fluid.owned, [&](std::size_t i) { set_fluid_pressure(fluid, eos, 0, i); });
}

template <int Dim>
void update_solid_stress(State<Dim>& state, double artificial_stress) {
    auto& solid = state.solid;
    if (solid.owned == 0) return;
    const LinearEquationOfState eos = state.rubber->eos;
    parallel_for(solid.owned, [&](std::size_t i) { set_solid_stress(solid, eos, artificial_stress, i); });
}

template <int Dim>
double finish_fluid_step(State<Dim>& state, double acoustic_damping, double dt) {
    auto& fluid = state.fluid;
    if (fluid.owned == 0) return 0;
    const LinearEquationOfState eos = state.water->eos;
    return std::sqrt(nonnegative_max(fluid.owned, [&](std::size_t i) {
        advance_position_and_density(fluid, dt, i);
        for (const GhostPlane<Dim>& plane : state.ghost_planes) {
            if (!plane.is_mirror() || plane.distance(fluid.position[i]) >= 0) continue;
            fluid.position.set(i, plane.image_position(fluid.position[i]));
            fluid.velocity.set(i, plane.image_direction(fluid.velocity[i]));
        }
        set_fluid_pressure(fluid, eos, acoustic_damping, i);
        return norm2(fluid.velocity[i]);
    }));
}

template <int Dim>
double finish_solid_step(State<Dim>& state, double artificial_stress, double dt) {
    auto& solid = state.solid;
    if (solid.owned == 0) return 0;
    const LinearEquationOfState eos = state.rubber->eos;
    const double mu = state.rubber->shear_modulus;
    return std::sqrt(nonnegative_max(solid.owned, [&](std::size_t i) {
        advance_position_and_density(solid, dt, i);
        advance_stress(solid, mu, dt, i);
        set_solid_stress(solid, eos, artificial_stress, i);
        return norm2(solid.velocity[i]);
    }));
}

#define SLUICE_INSTANTIATE(Dim)                                          \
    template void update_fluid_pressure<Dim>(State<Dim>&);               \
    template void update_solid_stress<Dim>(State<Dim>&, double);         \
    template double finish_fluid_step<Dim>(State<Dim>&, double, double); \
    template double finish_solid_step<Dim>(State<Dim>&, double, double);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
