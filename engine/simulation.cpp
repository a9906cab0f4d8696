#include "engine/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/checkpoint/state_visitors.hpp"
#include "engine/errors.hpp"
#include "engine/particles/particle_set.hpp"
#include "engine/step/balances.hpp"
#include "engine/step/body_acceleration.hpp"
#include "engine/step/boundary_coupling.hpp"
#include "engine/step/contact.hpp"
#include "engine/step/context.hpp"
#include "engine/step/fluid.hpp"
#include "engine/step/hypoelastic_solid.hpp"
#include "engine/step/interface_coupling.hpp"
#include "engine/step/particle_shifting.hpp"
#include "engine/step/steady_load.hpp"
#include "engine/step/total_lagrangian_solid.hpp"
#include "engine/step/walls.hpp"

namespace sluice {
namespace {

/// Numbers of materials that each may pass can make steps that come to nothing, or to no end.
void check_steps(const Scene& scene, const Effects& effects, const std::vector<CourantLimit>& limits) {
    constexpr double most_steps = 1e15;    // a longer time and its next step are the same number
    constexpr double most_substeps = 1e6;  // of seconds each, for a hundred thousand particles
    double least = scene.method.time_step.value_or(limits.front().dt);
    for (const CourantLimit& limit : limits) {
        if (!(limit.dt > 0) || !std::isfinite(limit.dt))
            scene.fail("materials." + limit.medium,
                       fmt::format("found constants that make a time step of {} s, expected a number > 0", limit.dt));
        if (!scene.method.time_step) least = std::min(least, limit.dt);
    }
    if (scene.output.end / least > most_steps)
        scene.fail("output.end",
                   fmt::format("found {} s, which takes {:.2g} steps of {:.2g} s, expected {} at the most",
                               scene.output.end, scene.output.end / least, least, most_steps));
    const double dt = scene.method.time_step.value_or(limits.front().dt), substeps = dt / limits.back().dt;
    if (effects.has(Effect::solid_substeps) && substeps > most_substeps)
        scene.fail(
            "materials." + limits.back().medium,
            fmt::format("found a solid that takes {:.2g} steps in each step of {:.2g} s, expected {} at the most",
                        substeps, dt, most_substeps));
}

}  // namespace

template <int Dim>
struct Simulation<Dim>::Impl {
    explicit Impl(const Scene& s)
        : scene(s),
          effects(scene),
          state(place_particles<Dim>(scene, effects)),
          planner(scene, effects, courant_limits_of(scene, state)),
          smoothing(scene.method.smoothing_function),
          neighbors(state, effects, scene.method.smoothing_length, smoothing.support),
          context{scene, effects, state, neighbors, pair_method(), StepPlan{}},
          body_acceleration(context),
          fluid(context),
          shifting(context),
          walls(context),
          contact(context),
          hypoelastic(context, contact),
          total_lagrangian(context, contact),
          interface(context),
          boundary(context) {
        if (effects.has(Effect::total_lagrangian))
            limit_by_mode(scene, effects, total_lagrangian.fastest_mode(), total_lagrangian.fastest_damping(),
                          planner.limits().back());
        check_steps(scene, effects, planner.limits());
        context.plan = planner.next(fluid.speed(), norm(state.gravity));
        const double dt = context.plan.dt, of_solid = highest_speed(state.solid);
        neighbors.expect_motion(dt * fluid.max_speed(), dt * of_solid, dt / context.plan.substeps * of_solid);
        neighbors.update();
        forces();
        begin_steady_load(context);
    }

    /// Velocities at n ± 1/2, everything else at n. Rates of density are taken half-way, at the positions that belong
    /// to the velocities; forces are those of the end of the last step.
    ///   staggered Euler [Antoci2007]: between steps velocities stand at n − 1/2
    ///   kick-drift-kick: they are brought on to n, where the output sees them
    /// Viscous forces are those of the velocities at n − 1/2 in either, of first order in Δt.
    ///
    /// With more than one sub-step the solid goes through the step at its own rate: a hypoelastic one under the fluid's
    /// force of time n, a total-Lagrangian one under half of that step's impulse before it and half of the next one's
    /// after it, less what is steady in them, which acts all the time (engine/step/steady_load.hpp); the fluid's
    /// continuity then sees the solid's mean velocity over the step, at its place half-way. So both sides exchange the
    /// same momentum f Δt, and the work f · Δx that the solid takes up is the one that belongs to the motion that the
    /// fluid sees. With one sub-step and staggered Euler this is the paper's scheme.
    void step() {
        const double before = context.plan.dt;
        if (steps > 0) context.plan = planner.next(fluid.speed(), fluid.acceleration());
        const double dt = context.plan.dt;
        const bool synchronous = scene.method.integrator == Integrator::kick_drift_kick;
        // The first kick brings v from time 0 to 1/2.
        fluid.kick(steps == 0 || synchronous ? 0.5 * dt : 0.5 * (before + dt));
        fluid.filter();
        fluid.drift_halfway();
        const double solid_motion = advance_solid();
        const double wall_motion = walls.move_halfway(time);
        contact.add_motion(wall_motion);
        rates();
        const double shift = shifting.shift(steps);
        const double fluid_motion = fluid.finish() + shift;
        neighbors.add_motion(std::max(fluid_motion, wall_motion), solid_motion);
        ++steps;
        solid_steps += static_cast<std::uint64_t>(context.plan.substeps);
        time = planner.adaptive() ? time + dt : static_cast<double>(steps) * dt;
        walls.finish(time);
        update_neighbors();
        forces();
        if (synchronous) fluid.kick(0.5 * dt);
        if (effects.has(Effect::total_lagrangian)) total_lagrangian.push(0.5 * dt);
    }

    void forces() {
        body_acceleration.update(time);
        fluid.forces();
        walls.forces();
        if (effects.has(Effect::interface_force)) interface.forces();
        if (effects.has(Effect::moving_boundary)) boundary.forces();
    }

    void rates() {
        fluid.rates();
        walls.rates();
        if (effects.has(Effect::interface_force)) interface.rates();
        if (effects.has(Effect::moving_boundary)) boundary.rates();
    }

    double advance_solid() {
        return guarded([&] {
            if (effects.has(Effect::solid_stress)) return hypoelastic.advance();
            if (effects.has(Effect::total_lagrangian)) {
                follow_steady_load(context);
                total_lagrangian.push(0.5 * context.plan.dt);
                return total_lagrangian.advance();
            }
            return 0.0;
        });
    }
    void update_neighbors() {
        const auto scope = context.timer.measure(StepPhase::search);
        guarded([&] { return neighbors.update(), 0; });
    }

    /// Particles that fly apart until their cells cannot be numbered are a numerical failure.
    template <class Work>
    auto guarded(Work&& work) const {
        try {
            return work();
        } catch (const std::length_error& error) {
            throw NumericalError(
                fmt::format("the computation broke down: after step {} (t = {:.6g} s) {}; something drives them apart: "
                            "pressures or "
                            "speeds beyond what sound_speed bears, or too long a step (lower method.courant)",
                            steps, time, error.what()));
        }
    }

    /// visit(name, member) for what changes during a run. Everything else follows from the scene.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("time", time), visit("steps", steps), visit("solid_steps", solid_steps);
        visit("pairs", context.pairs), visit("plan", context.plan), visit("timer", context.timer);
        visit("planner", planner), visit("gravity", state.gravity.c);
        for (const SetId set : all_sets) {
            SetColumns<Dim> columns{state[set]};
            visit(name_of(set), columns);
        }
        visit("neighbors", neighbors);
        visit("fluid_part", fluid), visit("shifting", shifting), visit("walls", walls);
        visit("contact", contact), visit("hypoelastic", hypoelastic);
        visit("interface_coupling", interface), visit("boundary_coupling", boundary);
    }

    PairMethod<Dim> pair_method() const {
        return {scene.method.precision == "mixed" ? Precision::mixed : Precision::full, smoothing};
    }

    Scene scene;
    Effects effects;
    State<Dim> state;
    StepPlanner planner;
    Smoothing<Dim> smoothing;
    Neighborhood<Dim> neighbors;
    StepContext<Dim> context;
    BodyAcceleration<Dim> body_acceleration;
    FluidPart<Dim> fluid;
    ParticleShifting<Dim> shifting;
    WallPart<Dim> walls;
    SolidContact<Dim> contact;
    HypoelasticSolid<Dim> hypoelastic;
    TotalLagrangianSolid<Dim> total_lagrangian;
    InterfaceCoupling<Dim> interface;
    BoundaryCoupling<Dim> boundary;
    std::uint64_t steps = 0;
    std::uint64_t solid_steps = 0;
    double time = 0;
};

template <int Dim>
Simulation<Dim>::Simulation(const Scene& scene) {
    try {
        impl_ = std::make_unique<Impl>(scene);
    } catch (const std::length_error& error) {  // too far apart for the search's cells
        scene.fail("method.spacing", fmt::format("found {} m, at which {}; expected bodies and walls nearer together",
                                                 scene.method.spacing, error.what()));
    }
}
template <int Dim>
Simulation<Dim>::~Simulation() = default;

template <int Dim>
void Simulation<Dim>::step() {
    impl_->step();
}

template <int Dim>
double Simulation<Dim>::time() const {
    return impl_->time;
}
template <int Dim>
double Simulation<Dim>::time_step() const {
    return impl_->context.plan.dt;
}
template <int Dim>
int Simulation<Dim>::solid_substeps() const {
    return impl_->context.plan.substeps;
}
template <int Dim>
const std::vector<CourantLimit>& Simulation<Dim>::courant_limits() const {
    return impl_->planner.limits();
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
const ParticleSet<Dim>& Simulation<Dim>::fluid() const {
    return impl_->state.fluid;
}
template <int Dim>
const ParticleSet<Dim>& Simulation<Dim>::solid() const {
    return impl_->state.solid;
}
template <int Dim>
const ParticleSet<Dim>& Simulation<Dim>::wall() const {
    return impl_->state.wall;
}
template <int Dim>
Hyperelastic Simulation<Dim>::elastic_law() const {
    return impl_->state.rubber ? impl_->state.rubber->law : Hyperelastic{};
}
template <int Dim>
const ParticleSet<Dim>& Simulation<Dim>::interface() const {
    return impl_->state.elements;
}

template <int Dim>
const ParticleSet<Dim>& Simulation<Dim>::boundary() const {
    return impl_->state.boundary;
}

template <int Dim>
WorkCount Simulation<Dim>::work() const {
    const auto& s = *impl_;
    const std::uint64_t moved = s.steps * s.state.fluid.owned + s.solid_steps * s.state.solid.owned;
    return {s.steps, moved, s.context.pairs, s.neighbors.builds() + s.contact.builds()};
}
template <int Dim>
const PhaseTimer& Simulation<Dim>::timer() const {
    return impl_->context.timer;
}
template <int Dim>
EnergyBalance Simulation<Dim>::energy() const {
    EnergyBalance e = energy_of(impl_->state);
    e.elastic += impl_->total_lagrangian.hourglass_energy();
    e.contact = impl_->contact.energy();
    return e;
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
    const auto& b = impl_->state.boundary;
    for (std::size_t k = 0; k < b.owned; ++k)
        if (b.body[k] == body) sum += b.force[k];
    return sum;
}

template <int Dim>
Vec<Dim> Simulation<Dim>::contact_force_on(std::size_t body) const {
    return impl_->contact.force_on(body);
}

template <int Dim>
ClosestPair Simulation<Dim>::closest_pair(Neighbor to, double spacings, const CountsHere& counts) const {
    return sluice::closest_pair(impl_->context, to, spacings, counts);
}
template <int Dim>
void Simulation<Dim>::set_step_share(double share) {
    impl_->planner.set_share(share);
}
template <int Dim>
InterfaceBalance Simulation<Dim>::interface_balance() const {
    return impl_->effects.has(Effect::moving_boundary) ? impl_->boundary.balance() : impl_->interface.balance();
}
template <int Dim>
double Simulation<Dim>::max_speed() const {
    return impl_->fluid.max_speed();
}
template <int Dim>
double Simulation<Dim>::max_mach() const {
    return impl_->state.water ? impl_->fluid.max_speed() / impl_->state.water->eos.sound_speed : 0.0;
}
template <int Dim>
std::size_t Simulation<Dim>::memory_bytes() const {
    const auto& s = impl_->state;
    std::size_t bytes = s.surface.bytes() + impl_->neighbors.bytes() + impl_->contact.bytes();
    for (const SetId set : all_sets) bytes += bytes_of(s[set]);
    return bytes;
}
template <int Dim>
const std::vector<Index>& Simulation<Dim>::solid_index_of_id() const {
    return impl_->neighbors.solid_index_of_id();
}

template <int Dim>
std::shared_ptr<const void> Simulation<Dim>::part_with(const void* column) {
    std::shared_ptr<const void> memory;
    const auto look = [&](const ColumnInfo&, auto& values) {
        using Column = std::remove_reference_t<decltype(values)>;
        if (values.empty() || values.data() != column) return;
        const auto parted = std::make_shared<const Column>(std::move(values));
        values = *parted;
        memory = parted;
    };
    for (const SetId set : {SetId::fluid, SetId::solid, SetId::wall}) for_each_array(impl_->state[set], look);
    return memory;
}

template <int Dim>
void Simulation<Dim>::save(const StateWriter& writer) const {
    impl_->visit_state(writer);
}
template <int Dim>
void Simulation<Dim>::restore(const StateReader& reader) {
    impl_->visit_state(reader);
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace sluice
