#include "engine/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/errors.hpp"
#include "engine/state/visit.hpp"
#include "engine/step/balances.hpp"
#include "engine/step/material_update.hpp"
#include "engine/step/neighborhood.hpp"
#include "engine/step/views.hpp"
#include "kernels/fluid_passes.hpp"
#include "kernels/interface_passes.hpp"
#include "kernels/solid_passes.hpp"
#include "kernels/wall_passes.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
struct Simulation<Dim>::Impl {
    explicit Impl(const Scene& s)
        : scene(s),
          effects(scene),
          method(scene.method.precision == "mixed" ? Precision::mixed : Precision::full),
          state(place_particles<Dim>(scene, effects)),
          limits(courant_limits_of(scene, state)),
          plan(plan_steps(scene, limits, state.water && state.rubber)),
          neighbors(state, effects, scene.method.smoothing_length) {
        const MediumMethod& f = scene.method.fluid;
        const MediumMethod& r = scene.method.solid;
        if (state.water) fluid_terms = {f.artificial_viscosity, state.water->eos.sound_speed};
        if (state.rubber)
            solid_terms = {r.artificial_viscosity, state.rubber->eos.sound_speed, r.artificial_stress,
                           r.artificial_stress_exponent, scene.method.smoothing_length};
        if (state.water) max_speed = highest_speed(state.fluid);
        update_fluid_pressure(state);
        update_solid_stress(state, solid_terms.artificial_stress);
        neighbors.refresh_fluid_scalars();
        const double of_solid = highest_speed(state.solid);
        neighbors.expect_motion(plan.dt * max_speed, plan.dt * of_solid, solid_dt() * of_solid);
        // So that the first output shows what the start means for walls and solids.
        if (effects.has(Effect::fixed_wall)) update_wall_pressure();
        if (effects.has(Effect::interface_force)) update_interface_force();
    }

    /// The staggered explicit Euler scheme of the paper: velocities at n ± 1/2, everything else at n. Rates of density
    /// and stress are taken half-way, at the positions that belong to the velocities.
    ///
    /// With more than one sub-step the solid goes through the step at its own rate under the interface's force of
    /// time n; the fluid's continuity then sees the solid's mean velocity over the step, at its place half-way. So both
    /// sides exchange the same momentum f Δt, and the work f · Δx that the solid takes up is the one that belongs to
    /// the motion that the fluid sees. With one sub-step this is the paper's scheme.
    void step() {
        update_neighbors();
        fluid_forces();
        wall_forces();
        interface_forces();
        kick_fluid();
        filter_fluid();
        drift_fluid_halfway();
        const double solid_motion = advance_solid();
        fluid_rates();
        interface_rates();
        finish_fluid(solid_motion);
        ++steps;
    }

    /// The solid's own steps within a step. Returns a bound of how far its particles have moved. [m]
    double advance_solid() {
        if (!effects.has(Effect::solid_stress)) return 0;
        double motion = 0;
        begin_solid_motion();
        for (int s = 0; s < plan.substeps; ++s) {
            if (s > 0) update_solid_neighbors();
            solid_forces();
            kick_solid(steps == 0 && s == 0);
            filter_solid();
            drift_solid_halfway();
            solid_rates_halfway();
            motion += finish_solid();
        }
        end_solid_motion();
        return motion;
    }

    double solid_dt() const { return plan.dt / plan.substeps; }

    void update_neighbors() {
        search([&] { neighbors.update(); });
    }
    void update_solid_neighbors() {
        search([&] { neighbors.update_solid(); });
    }

    template <class Update>
    void search(Update&& update) {
        const auto scope = timer.measure(StepPhase::search);
        try {
            update();
        } catch (const std::length_error& error) {
            throw NumericalError(error.what());
        }
    }

    void fluid_forces() {
        if (!effects.has(Effect::fluid_pressure)) return;
        const auto scope = timer.measure(StepPhase::fluid_pass);
        auto& fluid = state.fluid;
        parallel_for(fluid.owned, [&](std::size_t i) { fluid.acceleration.set(i, state.gravity); });
        pairs += fluid_momentum<Dim>(view_of(fluid), neighbors.fluid_fluid, fluid_terms, method, fluid.acceleration);
    }

    void wall_forces() {
        if (!effects.has(Effect::fixed_wall)) return;
        const auto scope = timer.measure(StepPhase::wall_pass);
        update_wall_pressure();
        pairs += fixed_ghost_force<Dim>(view_of(state.fluid), view_of(state.wall), neighbors.fluid_wall, method,
                                        state.fluid.acceleration);
    }

    void update_wall_pressure() {
        pairs += fixed_ghost_pressure<Dim>(view_of(state.wall), view_of(state.fluid), neighbors.wall_fluid,
                                           state.gravity, method, state.wall.pressure);
        neighbors.refresh_wall_pressure();
    }

    void interface_forces() {
        if (!effects.has(Effect::interface_force)) return;
        const auto scope = timer.measure(StepPhase::interface_pass);
        const Vec<Dim> on_solid = update_interface_force();
        auto& fluid = state.fluid;
        const auto elements = view_of(state.elements);
        const Vec<Dim> on_fluid = add_interface_force_on_fluid<Dim>(view_of(fluid), elements, neighbors.fluid_element,
                                                                    method, block_totals, fluid.acceleration);
        add_interface_force_on_fluid<Dim>(view_of(fluid), elements, neighbors.image_element, method, block_totals,
                                          fluid.acceleration);
        record_balance(on_solid, on_fluid);
    }

    /// Pressure on the elements and what it does to the solid. Returns the whole force on the solid.
    Vec<Dim> update_interface_force() {
        auto& e = state.elements;
        auto& solid = state.solid;
        update_elements(solid.position, view_of(solid));
        std::fill(e.pressure.begin(), e.pressure.end(), 0.0);
        std::fill(e.image_pressure.begin(), e.image_pressure.end(), 0.0);
        const auto elements = view_of(e), fluid = view_of(state.fluid);
        add_interface_pressure<Dim>(elements, fluid, neighbors.element_fluid, method, e.pressure);
        add_interface_pressure<Dim>(elements, fluid, neighbors.element_image, method, e.image_pressure);
        for (std::size_t k = 0; k < e.owned; ++k) {
            e.pressure[k] += e.image_pressure[k];
            e.force.set(k, -e.pressure[k] * e.area_normal[k]);
            e.shared_force.set(k, e.solid_weight[k] > 0 ? (1 / e.solid_weight[k]) * e.force[k] : Vec<Dim>{});
        }
        for (auto& column : solid.interface_acceleration.c) std::fill(column.begin(), column.end(), 0.0);
        return interface_force_on_solid<Dim>(view_of(solid), elements, neighbors.solid_element, method, block_totals,
                                             solid.interface_acceleration);
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
    void update_elements(const VectorField<Dim>& solid_position, const ParticleView<Dim>& solid) {
        auto& e = state.elements;
        if constexpr (Dim == 2) state.surface.update(solid_position, neighbors.solid_index_of_id(), e);
        interface_weights<Dim>(view_of(e), solid, neighbors.element_solid, method, e.solid_weight, e.velocity);
        for (std::size_t k = 0; k < e.owned; ++k)
            if (e.solid_weight[k] == 0) e.area_normal.set(k, {});  // torn off its body
        neighbors.refresh_elements();
    }

    void kick_fluid() {
        const auto scope = timer.measure(StepPhase::update);
        const double interval = steps == 0 ? 0.5 * plan.dt : plan.dt;  // the first brings v from time 0 to 1/2
        auto& fluid = state.fluid;
        parallel_for(fluid.owned, [&](std::size_t i) {
            fluid.velocity.set(i, fluid.velocity[i] + interval * fluid.acceleration[i]);
        });
    }

    void filter_fluid() {
        if (!effects.has(Effect::velocity_filter)) return;
        const auto scope = timer.measure(StepPhase::filter_pass);
        auto& fluid = state.fluid;
        neighbors.refresh_fluid_velocities();
        // Eq. (16) acts once per step of the paper's scheme, and what it dissipates in a given time depends on how
        // often that is: a longer step takes as many of them at once.
        const double theta = std::pow(scene.method.fluid.velocity_filter, plan.single_rate_steps);
        pairs += velocity_filter<Dim>(view_of(fluid), neighbors.fluid_fluid, theta, method, fluid.velocity_correction);
    }

    /// With the filter's correction of the velocity first, in one go through memory.
    void drift_fluid_halfway() {
        const auto scope = timer.measure(StepPhase::update);
        auto& fluid = state.fluid;
        const bool filtered = effects.has(Effect::velocity_filter);
        parallel_for(fluid.owned, [&](std::size_t i) {
            Vec<Dim> v = fluid.velocity[i];
            if (filtered) fluid.velocity.set(i, v += fluid.velocity_correction[i]);
            fluid.position.set(i, fluid.position[i] + 0.5 * plan.dt * v);
        });
        neighbors.refresh_fluid_positions();
        neighbors.refresh_fluid_velocities();
    }

    void fluid_rates() {
        if (!effects.has(Effect::fluid_pressure)) return;
        auto& fluid = state.fluid;
        {
            const auto scope = timer.measure(StepPhase::density_pass);
            std::fill(fluid.density_rate.begin(), fluid.density_rate.end(), 0.0);
            pairs += continuity<Dim>(view_of(fluid), neighbors.fluid_fluid, method, fluid.density_rate);
        }
        if (!effects.has(Effect::fixed_wall)) return;
        const auto scope = timer.measure(StepPhase::wall_pass);
        pairs += fixed_ghost_continuity<Dim>(view_of(fluid), view_of(state.wall), neighbors.fluid_wall, method,
                                             fluid.density_rate);
    }

    void interface_rates() {
        if (!effects.has(Effect::interface_force)) return;
        const auto scope = timer.measure(StepPhase::interface_pass);
        update_elements(state.solid.halfway_position, halfway_view_of(state.solid));
        const auto fluid = view_of(state.fluid), elements = view_of(state.elements);
        add_interface_continuity<Dim>(fluid, elements, neighbors.fluid_element, method, state.fluid.density_rate);
        add_interface_continuity<Dim>(fluid, elements, neighbors.image_element, method, state.fluid.density_rate);
    }

    void finish_fluid(double solid_motion) {
        const auto scope = timer.measure(StepPhase::update);
        const double speed = finish_fluid_step(state, plan.dt);
        neighbors.refresh_fluid_positions();
        neighbors.refresh_fluid_scalars();
        max_speed = std::max(speed, max_speed);
        neighbors.add_motion(plan.dt * speed, solid_motion);
    }

    void begin_solid_motion() {
        if (!effects.has(Effect::interface_force)) return;
        state.solid.halfway_position = state.solid.position;
    }

    void end_solid_motion() {
        if (!effects.has(Effect::interface_force)) return;
        auto& solid = state.solid;
        for (std::size_t i = 0; i < solid.owned; ++i) {
            const Vec<Dim> before = solid.halfway_position[i], after = solid.position[i];
            solid.halfway_position.set(i, 0.5 * (before + after));
            solid.mean_velocity.set(i, (1 / plan.dt) * (after - before));
        }
    }

    void solid_forces() {
        const auto scope = timer.measure(StepPhase::solid_pass);
        auto& solid = state.solid;
        const bool coupled = effects.has(Effect::interface_force);
        parallel_for(solid.owned, [&](std::size_t i) {
            solid.acceleration.set(i, coupled ? state.gravity + solid.interface_acceleration[i] : state.gravity);
        });
        pairs += solid_momentum<Dim>(view_of(solid), neighbors.solid_solid, solid_terms, method, solid.acceleration);
    }

    void kick_solid(bool first) {
        const auto scope = timer.measure(StepPhase::update);
        const double interval = first ? 0.5 * solid_dt() : solid_dt();
        auto& solid = state.solid;
        parallel_for(solid.owned, [&](std::size_t i) {
            if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + interval * solid.acceleration[i]);
        });
    }

    void filter_solid() {
        if (!effects.has(Effect::solid_filter)) return;
        const auto scope = timer.measure(StepPhase::filter_pass);
        auto& solid = state.solid;
        pairs += velocity_filter<Dim>(view_of(solid), neighbors.solid_solid, scene.method.solid.velocity_filter, method,
                                      solid.velocity_correction);
        parallel_for(solid.owned, [&](std::size_t i) {
            if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + solid.velocity_correction[i]);
        });
    }

    void drift_solid_halfway() {
        const auto scope = timer.measure(StepPhase::update);
        auto& solid = state.solid;
        parallel_for(solid.owned, [&](std::size_t i) {
            solid.position.set(i, solid.position[i] + 0.5 * solid_dt() * solid.velocity[i]);
        });
    }

    void solid_rates_halfway() {
        const auto scope = timer.measure(StepPhase::gradient_pass);
        auto& solid = state.solid;
        std::fill(solid.density_rate.begin(), solid.density_rate.end(), 0.0);
        pairs += solid_rates<Dim>(view_of(solid), neighbors.solid_solid, method, solid.density_rate,
                                  solid.velocity_gradient);
    }

    /// Returns a bound of how far the particles have moved. [m]
    double finish_solid() {
        const auto scope = timer.measure(StepPhase::update);
        const double motion = solid_dt() * finish_solid_step(state, solid_terms.artificial_stress, solid_dt());
        neighbors.add_solid_motion(motion);
        return motion;
    }

    Scene scene;
    Effects effects;
    PairMethod<Dim> method;
    State<Dim> state;
    std::vector<CourantLimit> limits;
    StepPlan plan;
    Neighborhood<Dim> neighbors;
    FluidTerms fluid_terms;
    SolidTerms solid_terms;
    PhaseTimer timer;
    BlockTotals<Dim> block_totals;
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
    impl_->step();
}

template <int Dim>
double Simulation<Dim>::time() const {
    return static_cast<double>(impl_->steps) * impl_->plan.dt;
}
template <int Dim>
double Simulation<Dim>::time_step() const {
    return impl_->plan.dt;
}
template <int Dim>
int Simulation<Dim>::solid_substeps() const {
    return impl_->plan.substeps;
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
    const auto& [steps, substeps] = std::pair(impl_->steps, static_cast<std::uint64_t>(impl_->plan.substeps));
    const std::uint64_t moved = impl_->state.fluid.owned + substeps * impl_->state.solid.owned;
    return {steps, steps * moved, impl_->pairs, impl_->neighbors.builds()};
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
