#include "engine/step/fluid.hpp"

#include <algorithm>
#include <cmath>

#include "engine/step/balances.hpp"
#include "engine/step/material_update.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
FluidPart<Dim>::FluidPart(StepContext<Dim>& context) : c_(context) {
    auto& state = c_.state;
    if (!state.water) return;
    const MediumMethod& m = c_.scene.method.fluid;
    const EquationOfState& eos = state.water->eos;
    terms_.sound_speed = eos.sound_speed;
    if (c_.has(Effect::artificial_viscosity)) terms_.artificial_viscosity = m.artificial_viscosity;
    if (c_.has(Effect::acoustic_damping)) acoustic_damping_ = m.acoustic_damping;
    if (c_.has(Effect::laminar_viscosity)) {
        terms_.viscosity = m.viscous_form;
        terms_.kinematic_viscosity = state.water->viscosity;
    }
    if (c_.has(Effect::density_diffusion))
        diffusion_ = {c_.has(Effect::excess_density) ? DensityDiffusion::molteni_colagrossi : m.density_diffusion,
                      eos.sound_speed, m.diffusion_coefficient, eos.density, state.gravity};
    max_speed_ = speed_ = highest_speed(state.fluid);
    update_fluid_pressure(state);
    c_.state.fluid.refresh_ghosts(column::density, column::pressure, column::pressure_over_rho2);
}

template <int Dim>
void FluidPart<Dim>::forces() {
    if (!c_.has(Effect::fluid_pressure)) return;
    const auto scope = c_.timer.measure(StepPhase::fluid_pass);
    auto& fluid = c_.state.fluid;
    const Vec<Dim> gravity = c_.state.gravity;
    parallel_for(fluid.owned, [&](std::size_t i) { fluid.acceleration.set(i, gravity); });
    c_.pairs += fluid_momentum<Dim>(view_of(fluid), c_.neighbors.fluid_fluid, terms_, c_.method, fluid.acceleration);
}

template <int Dim>
void FluidPart<Dim>::kick(double interval) {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& fluid = c_.state.fluid;
    const auto kick_one = [&](std::size_t i) {
        fluid.velocity.set(i, fluid.velocity[i] + interval * fluid.acceleration[i]);
    };
    if (!c_.has(Effect::adaptive_step)) return parallel_for(fluid.owned, kick_one);
    acceleration_ = std::sqrt(nonnegative_max(fluid.owned, [&](std::size_t i) {
        kick_one(i);
        return norm2(fluid.acceleration[i]);
    }));
}

template <int Dim>
void FluidPart<Dim>::filter() {
    if (!c_.has(Effect::velocity_filter)) return;
    const auto scope = c_.timer.measure(StepPhase::filter_pass);
    auto& fluid = c_.state.fluid;
    c_.state.fluid.refresh_ghosts(column::velocity);
    // Eq. (16) acts once per step of the paper's scheme, and what it dissipates in a given time depends on how often
    // that is: a longer step takes as many of them at once.
    const double theta = std::pow(c_.scene.method.fluid.velocity_filter, c_.plan.single_rate_steps);
    c_.pairs +=
        velocity_filter<Dim>(view_of(fluid), c_.neighbors.fluid_fluid, theta, c_.method, fluid.velocity_correction);
}

template <int Dim>
void FluidPart<Dim>::drift_halfway() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& fluid = c_.state.fluid;
    const bool filtered = c_.has(Effect::velocity_filter);
    const double half = 0.5 * c_.plan.dt;
    parallel_for(fluid.owned, [&](std::size_t i) {
        Vec<Dim> v = fluid.velocity[i];
        if (filtered) fluid.velocity.set(i, v += fluid.velocity_correction[i]);
        fluid.position.set(i, fluid.position[i] + half * v);
    });
    fluid.refresh_ghosts(column::position, column::velocity);
}

template <int Dim>
void FluidPart<Dim>::rates() {
    if (!c_.has(Effect::fluid_pressure)) return;
    const auto scope = c_.timer.measure(StepPhase::density_pass);
    auto& fluid = c_.state.fluid;
    std::fill(fluid.density_rate.begin(), fluid.density_rate.end(), 0.0);
    const NeighborList& list = c_.neighbors.fluid_fluid;
    if (!c_.has(Effect::density_diffusion)) {
        c_.pairs += continuity<Dim>(view_of(fluid), list, c_.method, fluid.density_rate);
        return;
    }
    if (c_.has(Effect::density_gradient)) {
        c_.pairs += density_gradient<Dim>(view_of(fluid), list, c_.method, fluid.density_gradient);
        c_.state.fluid.refresh_ghosts(column::density_gradient);
    }
    ParticleView<Dim> view = view_of(fluid);
    if (c_.has(Effect::excess_density)) {
        // An image carries that of the particle which it shows: at a mirror the difference of heights would be wrong.
        Vec<Dim> per_height = (diffusion_.density / std::pow(diffusion_.sound_speed, 2)) * c_.state.gravity;
        for (int k = 0; k < Dim; ++k)
            if (c_.scene.periodic[static_cast<std::size_t>(k)]) per_height[k] = 0;  // nothing rests along this axis
        parallel_for(fluid.owned, [&](std::size_t i) {
            fluid.excess_density[i] = fluid.density[i] - dot(per_height, fluid.position[i]);
        });
        c_.state.fluid.refresh_ghosts(column::excess_density);
        view.density = fluid.excess_density.data();  // in the volumes too, where a percent does not matter
    }
    c_.pairs += diffusive_continuity<Dim>(view, list, diffusion_, c_.method, fluid.density_rate);
}

template <int Dim>
double FluidPart<Dim>::finish() {
    const auto scope = c_.timer.measure(StepPhase::update);
    speed_ = finish_fluid_step(c_.state, acoustic_damping_, c_.plan.dt);
    c_.state.fluid.refresh_ghosts(column::position, column::density, column::pressure, column::pressure_over_rho2);
    max_speed_ = std::max(speed_, max_speed_);
    return c_.plan.dt * speed_;
}

template class FluidPart<2>;
template class FluidPart<3>;

}  // namespace sluice
