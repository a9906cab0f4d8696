#include "engine/simulation.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/errors.hpp"
#include "engine/state/visit.hpp"
#include "engine/step/balances.hpp"
#include "engine/step/material_update.hpp"
#include "engine/step/neighborhood.hpp"
#include "engine/step/views.hpp"
#include "kernels/interface_passes.hpp"
#include "kernels/solid_passes.hpp"
#include "kernels/wall_passes.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// Courant limits of the media present: dt = courant · h / c0 with each medium's smallest h.
template <int Dim>
std::vector<CourantLimit> courant_limits_of(const Scene& scene, const State<Dim>& state) {
    std::vector<CourantLimit> limits;
    const auto add = [&](const PhaseBase<Dim>& phase, const std::optional<Medium>& medium) {
        if (!medium) return;
        const auto& h = phase.smoothing_length;
        limits.push_back(
            {medium->name, scene.method.courant * *std::min_element(h.begin(), h.end()) / medium->eos.sound_speed});
    };
    add(state.fluid, state.water);
    add(state.solid, state.rubber);
    return limits;
}

double time_step_of(const Scene& scene, const std::vector<CourantLimit>& limits) {
    if (scene.method.time_step) return *scene.method.time_step;
    const auto least =
        std::min_element(limits.begin(), limits.end(), [](const auto& a, const auto& b) { return a.dt < b.dt; });
    return least->dt;
}

}  // namespace

template <int Dim>
struct Simulation<Dim>::Impl {
    explicit Impl(const Scene& s)
        : scene(s),
          effects(scene),
          state(place_particles<Dim>(scene, effects)),
          limits(courant_limits_of(scene, state)),
          dt(time_step_of(scene, limits)),
          neighbors(state, effects) {
        const MediumMethod& f = scene.method.fluid;
        const MediumMethod& r = scene.method.solid;
        if (state.water) fluid_terms = {f.artificial_viscosity, state.water->eos.sound_speed};
        if (state.rubber)
            solid_terms = {r.artificial_viscosity, state.rubber->eos.sound_speed, r.artificial_stress,
                           r.artificial_stress_exponent, scene.method.smoothing_length};
        if (state.water) max_speed = highest_speed(state.fluid);
        update_pressure_and_stress();
        update_boundary_pressures<double>();  // so that the first output shows what the start means for walls and
                                              // solids
    }

    /// The staggered explicit Euler scheme of the paper: velocities at n ± 1/2, everything else at n. Rates of density
    /// and stress are taken half-way, at the positions that belong to the velocities.
    template <class Real>
    void step() {
        if (neighbors.outdated()) rebuild_neighbors();
        start_accelerations();
        fluid_forces<Real>();
        wall_forces<Real>();
        solid_forces<Real>();
        interface_forces<Real>();
        kick(steps == 0 ? 0.5 * dt : dt);  // the first brings v from time 0 to 1/2
        filter_velocities<Real>();
        drift(0.5 * dt);
        rates<Real>();
        drift(0.5 * dt);
        advance_material();
        ++steps;
    }

    void rebuild_neighbors() {
        const auto scope = timer.measure(StepPhase::search);
        try {
            neighbors.rebuild();
        } catch (const std::length_error& error) {
            throw NumericalError(error.what());
        }
    }

    void start_accelerations() {
        const auto scope = timer.measure(StepPhase::update);
        for (PhaseBase<Dim>* phase :
             {static_cast<PhaseBase<Dim>*>(&state.fluid), static_cast<PhaseBase<Dim>*>(&state.solid)})
            parallel_for(phase->owned, [&](std::size_t i) { phase->acceleration.set(i, state.gravity); });
    }

    template <class Real>
    void fluid_forces() {
        if (!effects.has(Effect::fluid_pressure)) return;
        const auto scope = timer.measure(StepPhase::fluid_pass);
        pairs += fluid_momentum<Dim, Real>(view_of(state.fluid), neighbors.fluid_fluid, fluid_terms,
                                           state.fluid.acceleration);
    }

    template <class Real>
    void wall_forces() {
        if (!effects.has(Effect::fixed_wall)) return;
        const auto scope = timer.measure(StepPhase::wall_pass);
        update_wall_pressure<Real>();
        pairs += fixed_ghost_force<Dim, Real>(view_of(state.fluid), view_of(state.wall), neighbors.fluid_wall,
                                              state.fluid.acceleration);
    }

    template <class Real>
    void update_wall_pressure() {
        pairs += fixed_ghost_pressure<Dim, Real>(view_of(state.wall), view_of(state.fluid), neighbors.wall_fluid,
                                                 state.gravity, state.wall.pressure);
        neighbors.refresh_wall_pressure();
    }

    template <class Real>
    void solid_forces() {
        if (!effects.has(Effect::solid_stress)) return;
        const auto scope = timer.measure(StepPhase::solid_pass);
        pairs += solid_momentum<Dim, Real>(view_of(state.solid), neighbors.solid_solid, solid_terms,
                                           state.solid.acceleration);
    }

    template <class Real>
    void interface_forces() {
        if (!effects.has(Effect::interface_force)) return;
        const auto scope = timer.measure(StepPhase::interface_pass);
        update_interface_pressure<Real>();
        const auto& e = state.elements;
        const auto elements = view_of(e);
        const Vec<Dim> on_solid = interface_force_on_solid<Dim, Real>(
            view_of(state.solid), elements, neighbors.solid_element, e.solid_weight, e.force, state.solid.acceleration);
        const Vec<Dim> on_fluid = interface_force_on_fluid<Dim, Real>(
            view_of(state.fluid), elements, neighbors.fluid_element, state.fluid.acceleration);
        record_balance(on_solid, on_fluid);
    }

    template <class Real>
    void update_interface_pressure() {
        update_elements<Real>();
        auto& e = state.elements;
        interface_pressure<Dim, Real>(view_of(e), view_of(state.fluid), state.fluid.owned, neighbors.element_fluid,
                                      e.pressure, e.image_pressure);
        for (std::size_t k = 0; k < e.owned; ++k) e.force.set(k, -e.pressure[k] * e.area_normal[k]);
    }

    template <class Real>
    void update_boundary_pressures() {
        if (effects.has(Effect::fixed_wall)) update_wall_pressure<Real>();
        if (effects.has(Effect::interface_force)) update_interface_pressure<Real>();
    }

    /// What fluid and solid give each other must add up to nothing, but for what images of the fluid, that is the
    /// mirror walls, give to the solid.
    void record_balance(const Vec<Dim>& on_solid, const Vec<Dim>& on_fluid) {
        const auto& e = state.elements;
        Vec<Dim> sum = on_solid + on_fluid;
        double magnitude = 0;
        for (std::size_t k = 0; k < e.owned; ++k) {
            sum += e.image_pressure[k] * e.area_normal[k];
            magnitude += norm(e.force[k]);
        }
        balance.force = magnitude;
        if (magnitude > 0) balance.residual = std::max(balance.residual, norm(sum) / magnitude);
    }

    /// Elements follow the solid: place and area from the boundary particles, velocity from the weights of its forces.
    template <class Real>
    void update_elements() {
        if constexpr (Dim == 2) state.surface.update(state.solid, neighbors.solid_index_of_id(), state.elements);
        interface_weights<Dim, Real>(view_of(state.elements), view_of(state.solid), neighbors.element_solid,
                                     state.elements.solid_weight, state.elements.velocity);
        for (std::size_t k = 0; k < state.elements.owned; ++k)
            if (state.elements.solid_weight[k] == 0) state.elements.area_normal.set(k, {});  // torn off its body
        neighbors.refresh_elements();
    }

    void kick(double interval) {
        const auto scope = timer.measure(StepPhase::update);
        auto& fluid = state.fluid;
        auto& solid = state.solid;
        parallel_for(fluid.owned, [&](std::size_t i) {
            fluid.velocity.set(i, fluid.velocity[i] + interval * fluid.acceleration[i]);
        });
        parallel_for(solid.owned, [&](std::size_t i) {
            if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + interval * solid.acceleration[i]);
        });
    }

    template <class Real>
    void filter_velocities() {
        if (!effects.has(Effect::velocity_filter) && !effects.has(Effect::solid_filter)) return;
        const auto scope = timer.measure(StepPhase::filter_pass);
        if (effects.has(Effect::velocity_filter)) {
            neighbors.refresh_fluid_velocities();
            pairs += velocity_filter<Dim, Real>(view_of(state.fluid), neighbors.fluid_fluid,
                                                scene.method.fluid.velocity_filter, state.fluid.velocity_correction);
            auto& fluid = state.fluid;
            parallel_for(fluid.owned, [&](std::size_t i) {
                fluid.velocity.set(i, fluid.velocity[i] + fluid.velocity_correction[i]);
            });
        }
        if (effects.has(Effect::solid_filter)) {
            auto& solid = state.solid;
            pairs += velocity_filter<Dim, Real>(view_of(solid), neighbors.solid_solid,
                                                scene.method.solid.velocity_filter, solid.velocity_correction);
            parallel_for(solid.owned, [&](std::size_t i) {
                if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + solid.velocity_correction[i]);
            });
        }
    }

    void drift(double interval) {
        const auto scope = timer.measure(StepPhase::update);
        for (PhaseBase<Dim>* phase :
             {static_cast<PhaseBase<Dim>*>(&state.fluid), static_cast<PhaseBase<Dim>*>(&state.solid)})
            parallel_for(phase->owned, [&](std::size_t i) {
                phase->position.set(i, phase->position[i] + interval * phase->velocity[i]);
            });
        neighbors.refresh_fluid_positions();
    }

    template <class Real>
    void rates() {
        if (effects.has(Effect::fluid_pressure)) fluid_rates<Real>();
        if (effects.has(Effect::solid_stress)) {
            const auto scope = timer.measure(StepPhase::gradient_pass);
            std::fill(state.solid.density_rate.begin(), state.solid.density_rate.end(), 0.0);
            pairs += solid_rates<Dim, Real>(view_of(state.solid), neighbors.solid_solid, state.solid.density_rate,
                                            state.solid.velocity_gradient);
        }
        if (effects.has(Effect::interface_force)) {
            const auto scope = timer.measure(StepPhase::interface_pass);
            update_elements<Real>();
            interface_continuity<Dim, Real>(view_of(state.fluid), view_of(state.elements), neighbors.fluid_element,
                                            state.fluid.density_rate);
        }
    }

    template <class Real>
    void fluid_rates() {
        auto& fluid = state.fluid;
        neighbors.refresh_fluid_velocities();
        {
            const auto scope = timer.measure(StepPhase::density_pass);
            std::fill(fluid.density_rate.begin(), fluid.density_rate.end(), 0.0);
            pairs += continuity<Dim, Real>(view_of(fluid), neighbors.fluid_fluid, fluid.density_rate);
        }
        if (!effects.has(Effect::fixed_wall)) return;
        const auto scope = timer.measure(StepPhase::wall_pass);
        pairs += fixed_ghost_continuity<Dim, Real>(view_of(fluid), view_of(state.wall), neighbors.fluid_wall,
                                                   fluid.density_rate);
    }

    void advance_material() {
        const auto scope = timer.measure(StepPhase::update);
        advance_density<Dim>(state.fluid, dt);
        advance_density<Dim>(state.solid, dt);
        advance_stress(state, dt);
        neighbors.reflect_strays();
        update_pressure_and_stress();
        const double fluid_speed = highest_speed(state.fluid), solid_speed = highest_speed(state.solid);
        neighbors.add_motion(dt * std::max(fluid_speed, solid_speed));
        max_speed = std::max(fluid_speed, max_speed);
    }

    void update_pressure_and_stress() {
        update_fluid_pressure(state);
        update_solid_stress(state, solid_terms.artificial_stress);
        neighbors.refresh_fluid_positions();
        neighbors.refresh_fluid_scalars();
    }

    Scene scene;
    Effects effects;
    State<Dim> state;
    std::vector<CourantLimit> limits;
    double dt;
    Neighborhood<Dim> neighbors;
    FluidTerms fluid_terms;
    SolidTerms solid_terms;
    PhaseTimer timer;
    std::uint64_t steps = 0;
    std::uint64_t pairs = 0;
    double max_speed = 0;
    InterfaceBalance balance;
};

template <int Dim>
Simulation<Dim>::Simulation(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
template <int Dim>
Simulation<Dim>::~Simulation() = default;

template <int Dim>
void Simulation<Dim>::step() {
    if (impl_->scene.method.precision == "mixed")
        impl_->template step<float>();
    else
        impl_->template step<double>();
}

template <int Dim>
double Simulation<Dim>::time() const {
    return static_cast<double>(impl_->steps) * impl_->dt;
}
template <int Dim>
double Simulation<Dim>::time_step() const {
    return impl_->dt;
}
template <int Dim>
const std::vector<CourantLimit>& Simulation<Dim>::courant_limits() const {
    return impl_->limits;
}
template <int Dim>
const Scene& Simulation<Dim>::scene() const {
    return impl_->scene;
}
template <int Dim>
const Effects& Simulation<Dim>::effects() const {
    return impl_->effects;
}
template <int Dim>
const FluidPhase<Dim>& Simulation<Dim>::fluid() const {
    return impl_->state.fluid;
}
template <int Dim>
const SolidPhase<Dim>& Simulation<Dim>::solid() const {
    return impl_->state.solid;
}
template <int Dim>
const WallPhase<Dim>& Simulation<Dim>::wall() const {
    return impl_->state.wall;
}
template <int Dim>
const InterfaceElements<Dim>& Simulation<Dim>::interface() const {
    return impl_->state.elements;
}

template <int Dim>
WorkCount Simulation<Dim>::work() const {
    const std::uint64_t moving = impl_->state.fluid.owned + impl_->state.solid.owned;
    return {impl_->steps, impl_->steps * moving, impl_->pairs, impl_->neighbors.builds()};
}
template <int Dim>
const PhaseTimer& Simulation<Dim>::timer() const {
    return impl_->timer;
}
template <int Dim>
EnergyBalance Simulation<Dim>::energy() const {
    return energy_of(impl_->state);
}
template <int Dim>
Vec<Dim> Simulation<Dim>::momentum() const {
    return momentum_of(impl_->state);
}

template <int Dim>
Vec<Dim> Simulation<Dim>::force_on(std::size_t body) const {
    const auto& e = impl_->state.elements;
    Vec<Dim> sum;
    for (std::size_t k = 0; k < e.owned; ++k)
        if (e.body[k] == body) sum += e.force[k];
    return sum;
}

template <int Dim>
InterfaceBalance Simulation<Dim>::interface_balance() const {
    return impl_->balance;
}
template <int Dim>
double Simulation<Dim>::max_speed() const {
    return impl_->max_speed;
}
template <int Dim>
double Simulation<Dim>::max_mach() const {
    return impl_->state.water ? impl_->max_speed / impl_->state.water->eos.sound_speed : 0.0;
}
template <int Dim>
std::size_t Simulation<Dim>::memory_bytes() const {
    const auto& s = impl_->state;
    return column_bytes(s.fluid) + column_bytes(s.solid) + column_bytes(s.wall) + column_bytes(s.elements) +
           impl_->neighbors.bytes();
}
template <int Dim>
const std::vector<Index>& Simulation<Dim>::solid_index_of_id() const {
    return impl_->neighbors.solid_index_of_id();
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace sluice
