#include "engine/step/parts/fluid.hpp"

#include <algorithm>
#include <cmath>

#include "engine/files/state_visitors.hpp"
#include "engine/scene/light_solid.hpp"
#include "engine/step/balances.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

template <int Dim>
void set_pressure(ParticleSet<Dim>& fluid, const EquationOfState& eos, double acoustic_damping, std::size_t i) {
    const double rho = fluid.density[i];
    double p = eos.pressure(rho);
    if (acoustic_damping != 0)
        p += acoustic_damping * eos.sound_speed * fluid.smoothing_length[i] * fluid.density_rate[i];
    fluid.pressure[i] = p;
    fluid.pressure_over_rho2[i] = p / (rho * rho);
}

/// Whether velocities belong to the same time as positions where steps begin and end.
bool is_synchronous(Integrator integrator) {
    switch (integrator) {
        case Integrator::staggered_euler:
            return false;
        case Integrator::kick_drift_kick:
            return true;
    }
    return {};
}

}  // namespace

template <int Dim>
FluidPart<Dim>::FluidPart(StepContext<Dim>& context)
    : c_(context), list_(context.neighbors.pair({SetId::fluid, SetId::fluid}).list), shifting_(context) {
    const MediumMethod& m = c_.scene.method.fluid;
    const MaterialConstants& material = c_.state.fluid_materials.front();
    terms_.sound_speed = material.eos.sound_speed;
    terms_.multiphase = c_.has(Effect::several_fluids);
    if (c_.has(Effect::artificial_viscosity)) terms_.artificial_viscosity = m.artificial_viscosity;
    if (c_.has(Effect::acoustic_damping)) acoustic_damping_ = m.acoustic_damping;
    if (c_.has(Effect::laminar_viscosity)) {
        terms_.viscosity = m.viscous_form;
        terms_.kinematic_viscosity = material.viscosity;
    }
    diffusion_.coefficient = 0;
    if (c_.has(Effect::density_diffusion))
        diffusion_ = {c_.has(Effect::excess_density) ? DensityDiffusion::molteni_colagrossi : m.density_diffusion,
                      material.eos.sound_speed, m.diffusion_coefficient, material.eos.density, c_.state.gravity};
}

template <int Dim>
void FluidPart<Dim>::start() {
    c_.flow.highest = c_.flow.now = highest_speed(c_.state.fluid);
    update_pressure();
    c_.state.fluid.refresh_ghosts(column::density, column::pressure, column::pressure_over_rho2);
}

template <int Dim>
void FluidPart<Dim>::limit_step(std::vector<CourantLimit>& limits) const {
    const auto& fluid = c_.state.fluid;
    const double share = light_solid(c_.scene).step_share;
    for (const MaterialConstants& material : c_.state.fluid_materials) {
        double h = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < fluid.owned; ++i)
            if (c_.state.fluid_materials.of_body(fluid.body[i]).number == material.number)
                h = std::min(h, fluid.smoothing_length[i]);
        const double c0 = material.eos.sound_speed, nu = material.viscosity;
        const double dt = share * c_.scene.method.courant * h / c0;
        limits.push_back({SetId::fluid, c_.scene.materials[material.number].name,
                          nu > 0 ? std::min(dt, 0.125 * h * h / nu) : dt, h, c0, nu});
    }
}

template <int Dim>
void FluidPart<Dim>::first_half() {
    const double dt = c_.plan.dt;
    const bool synchronous = is_synchronous(c_.scene.method.integrator);
    // The first kick brings v from time 0 to 1/2.
    kick(c_.steps == 0 || synchronous ? 0.5 * dt : 0.5 * (last_dt_ + dt));
    last_dt_ = dt;
    filter();
    drift_halfway();
}

template <int Dim>
void FluidPart<Dim>::second_half() {
    const double shifted = shifting_.shift(c_.steps);
    const auto scope = c_.timer.measure(StepPhase::update);
    c_.flow.now = drift_to_end();
    c_.state.fluid.refresh_ghosts(column::position, column::density, column::pressure, column::pressure_over_rho2);
    c_.flow.highest = std::max(c_.flow.now, c_.flow.highest);
    c_.motion.fluid = c_.plan.dt * c_.flow.now + shifted;
}

template <int Dim>
void FluidPart<Dim>::forces() {
    const auto scope = c_.timer.measure(StepPhase::fluid_pass);
    auto& fluid = c_.state.fluid;
    const Vec<Dim> gravity = c_.state.gravity;
    parallel_for(fluid.owned, [&](std::size_t i) { fluid.acceleration.set(i, gravity); });
    c_.pairs += fluid_momentum<Dim>(view_of(fluid), list_, terms_, c_.method, fluid.acceleration);
}

template <int Dim>
void FluidPart<Dim>::last_kick() {
    if (is_synchronous(c_.scene.method.integrator)) kick(0.5 * c_.plan.dt);
}

template <int Dim>
void FluidPart<Dim>::kick(double interval) {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& fluid = c_.state.fluid;
    const auto kick_one = [&](std::size_t i) {
        fluid.velocity.set(i, fluid.velocity[i] + interval * fluid.acceleration[i]);
    };
    if (!c_.has(Effect::adaptive_step)) return parallel_for(fluid.owned, kick_one);
    c_.flow.acceleration = std::sqrt(nonnegative_max(fluid.owned, [&](std::size_t i) {
        kick_one(i);
        return norm2(fluid.acceleration[i]);
    }));
}

template <int Dim>
void FluidPart<Dim>::filter() {
    if (!c_.has(Effect::velocity_filter)) return;
    const auto scope = c_.timer.measure(StepPhase::filter_pass);
    auto& fluid = c_.state.fluid;
    fluid.refresh_ghosts(column::velocity);
    // Eq. (16) acts once per step of the paper's scheme, and what it dissipates in a given time depends on how often
    // that is: a longer step takes as many of them at once.
    const double theta = std::pow(c_.scene.method.fluid.velocity_filter, c_.plan.single_rate_steps);
    c_.pairs += velocity_filter<Dim>(view_of(fluid), list_, theta, c_.method, fluid.velocity_correction);
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
    const auto scope = c_.timer.measure(StepPhase::density_pass);
    auto& fluid = c_.state.fluid;
    std::fill(fluid.density_rate.begin(), fluid.density_rate.end(), 0.0);
    if (c_.has(Effect::several_fluids)) {
        update_excess_density();
        c_.pairs +=
            multiphase_continuity<Dim>(view_of(fluid), list_, diffusion_.coefficient, c_.method, fluid.density_rate);
        return;
    }
    if (!c_.has(Effect::density_diffusion)) {
        c_.pairs += continuity<Dim>(view_of(fluid), list_, c_.method, fluid.density_rate);
        return;
    }
    if (c_.has(Effect::density_gradient)) {
        c_.pairs += density_gradient<Dim>(view_of(fluid), list_, c_.method, fluid.density_gradient);
        fluid.refresh_ghosts(column::density_gradient);
    }
    if (c_.has(Effect::excess_density)) update_excess_density();
    ParticleView<Dim> view = view_of(fluid);
    if (c_.has(Effect::excess_density))
        view.density = fluid.excess_density.data();  // in the volumes too, where a percent does not matter
    c_.pairs += diffusive_continuity<Dim>(view, list_, diffusion_, c_.method, fluid.density_rate);
}

/// A ghost has its parent's value: across a mirror the difference of heights would be wrong.
template <int Dim>
void FluidPart<Dim>::update_excess_density() {
    auto& fluid = c_.state.fluid;
    // Slope of the density at rest, over ρ0/c0²; none along a periodic axis, where nothing rests.
    Vec<Dim> per_height = c_.has(Effect::excess_density) ? c_.state.gravity : Vec<Dim>{};
    for (int k = 0; k < Dim; ++k)
        if (c_.scene.periodic[static_cast<std::size_t>(k)]) per_height[k] = 0;
    with_materials(c_.state.fluid_materials, fluid.body, [&](const auto& material) {
        parallel_for(fluid.owned, [&](std::size_t i) {
            const EquationOfState& eos = material(i).eos;
            const Vec<Dim> slope = (eos.density / std::pow(eos.sound_speed, 2)) * per_height;
            fluid.excess_density[i] = fluid.density[i] - dot(slope, fluid.position[i]);
        });
    });
    fluid.refresh_ghosts(column::excess_density);
}

template <int Dim>
void FluidPart<Dim>::update_pressure() {
    auto& fluid = c_.state.fluid;
    with_materials(c_.state.fluid_materials, fluid.body, [&](const auto& material) {
        parallel_for(fluid.owned, [&](std::size_t i) { set_pressure(fluid, material(i).eos, 0, i); });
    });
}

template <int Dim>
double FluidPart<Dim>::drift_to_end() {
    auto& fluid = c_.state.fluid;
    const double dt = c_.plan.dt, acoustic_damping = acoustic_damping_;
    const auto& planes = c_.state.ghost_planes;
    return with_materials(c_.state.fluid_materials, fluid.body, [&](const auto& material) {
        return std::sqrt(nonnegative_max(fluid.owned, [&](std::size_t i) {
            fluid.position.set(i, fluid.position[i] + 0.5 * dt * fluid.velocity[i]);
            fluid.density[i] += dt * fluid.density_rate[i];
            for (const GhostPlane<Dim>& plane : planes) {
                if (!plane.is_mirror() || plane.distance(fluid.position[i]) >= 0) continue;
                fluid.position.set(i, plane.image_position(fluid.position[i]));
                fluid.velocity.set(i, plane.image_direction(fluid.velocity[i]));
            }
            set_pressure(fluid, material(i).eos, acoustic_damping, i);
            return norm2(fluid.velocity[i]);
        }));
    });
}

template <int Dim>
void FluidPart<Dim>::add_energy(EnergyBalance& e) const {
    const auto& fluid = c_.state.fluid;
    const PartRange all{0, fluid.owned};
    add_motion(fluid, all, c_.state.gravity, e);
    add_compression(fluid, all, c_.state.fluid_materials, e);
}

template <int Dim>
Vec<Dim> FluidPart<Dim>::momentum() const {
    return momentum_of(c_.state.fluid, PartRange{0, c_.state.fluid.owned});
}

template <int Dim>
void FluidPart<Dim>::save(const StateWriter& writer) {
    visit_state(writer);
}
template <int Dim>
void FluidPart<Dim>::restore(const StateReader& reader) {
    visit_state(reader);
}

template class FluidPart<2>;
template class FluidPart<3>;

}  // namespace sluice
