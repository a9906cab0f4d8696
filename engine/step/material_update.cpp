#include "engine/step/material_update.hpp"

#include "kernels/terms/artificial_stress.hpp"
#include "kernels/terms/jaumann.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
void update_fluid_pressure(State<Dim>& state) {
    auto& fluid = state.fluid;
    if (fluid.owned == 0) return;
    const LinearEquationOfState eos = state.water->eos;
    parallel_for(fluid.owned, [&](std::size_t i) {
        const double rho = fluid.density[i], p = eos.pressure(rho);
        fluid.pressure[i] = p;
        fluid.pressure_over_rho2[i] = p / (rho * rho);
    });
}

template <int Dim>
void update_solid_stress(State<Dim>& state, double artificial_stress) {
    auto& solid = state.solid;
    if (solid.owned == 0) return;
    const LinearEquationOfState eos = state.rubber->eos;
    parallel_for(solid.owned, [&](std::size_t i) {
        const double rho = solid.density[i], p = eos.pressure(rho);
        solid.pressure[i] = p;
        auto s = solid.deviatoric_stress[i];
        for (int k = 0; k < Dim; ++k) s[k] -= p;
        s *= 1 / (rho * rho);
        solid.stress_over_rho2.set(i, s);
        if (artificial_stress != 0) solid.artificial_stress.set(i, tensile_correction(s, artificial_stress));
    });
}

template <int Dim>
void advance_density(PhaseBase<Dim>& phase, double dt) {
    parallel_for(phase.owned, [&](std::size_t i) { phase.density[i] += dt * phase.density_rate[i]; });
}

template <int Dim>
void advance_stress(State<Dim>& state, double dt) {
    auto& solid = state.solid;
    if (solid.owned == 0) return;
    const double mu = state.rubber->shear_modulus;
    parallel_for(solid.owned, [&](std::size_t i) {
        const auto packed = solid.velocity_gradient[i];
        Tensor<Dim> gradient;
        for (int k = 0; k < Dim * Dim; ++k) gradient(k / Dim, k % Dim) = packed[k];
        const Tensor<Dim> s = sym_to_tensor<Dim>(solid.deviatoric_stress[i]);
        solid.deviatoric_stress.set(i, tensor_to_sym<Dim>(advance_deviatoric_stress<Dim>(s, gradient, mu, dt)));
    });
}

#define SLUICE_INSTANTIATE(Dim)                                  \
    template void update_fluid_pressure<Dim>(State<Dim>&);       \
    template void update_solid_stress<Dim>(State<Dim>&, double); \
    template void advance_density<Dim>(PhaseBase<Dim>&, double); \
    template void advance_stress<Dim>(State<Dim>&, double);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
