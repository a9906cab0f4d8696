#include "engine/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/base/errors.hpp"
#include "engine/files/state_visitors.hpp"
#include "engine/particles/set_columns.hpp"
#include "engine/scene/formula.hpp"
#include "engine/step/balances.hpp"
#include "engine/step/couplings/make_couplings.hpp"
#include "engine/step/parts/make_parts.hpp"

namespace sluice {
namespace {

/// Gravity, plus an acceleration of everything that depends on time, as in a shaken tank seen from within.
template <int Dim>
class BodyAcceleration {
  public:
    explicit BodyAcceleration(StepContext<Dim>& context) : c_(context), constant_(context.state.gravity) {
        if (!c_.has(Effect::driven_acceleration)) return;
        for (std::size_t k = 0; k < Dim; ++k)
            driven_.emplace_back(c_.scene, "acceleration", c_.scene.acceleration[k], Variable::time);
    }

    /// Sets the state's gravity to its value at time t. [s]
    void update(double t) {
        if (driven_.empty()) return;
        c_.state.gravity = constant_;
        for (int k = 0; k < Dim; ++k) c_.state.gravity[k] += driven_[static_cast<std::size_t>(k)](t);
    }

  private:
    StepContext<Dim>& c_;
    Vec<Dim> constant_;  ///< [m/s²]
    std::vector<CompiledFormula> driven_;
};

}  // namespace

template <int Dim>
struct Simulation<Dim>::Impl {
    explicit Impl(const Scene& s)
        : scene(s),
          effects(scene),
          state(place_particles<Dim>(scene, effects)),
          smoothing(scene.method.smoothing_function),
          neighbors(state, effects, scene.method.smoothing_length, smoothing.support),
          context{scene, effects, state, neighbors, pair_method(), StepPlan{}},
          body_acceleration(context),
          parts(make_parts(context)),
          planner(start()) {
        context.plan = planner.next(context.flow.now, norm(state.gravity));
        const double dt = context.plan.dt, of_solid = highest_speed(state.solid);
        neighbors.expect_motion(dt * context.flow.highest, dt * of_solid, dt / context.plan.substeps * of_solid);
        neighbors.update();
        forces();
    }

    /// Starts everything but the first forces. Returns a planner with the parts' limits.
    StepPlanner start() {
        context.couplings = make_couplings(context);
        neighbors.build();
        for (const auto& coupling : context.couplings) coupling->start();
        for (const auto& part : parts) part->start();
        std::vector<CourantLimit> limits;
        for (const auto& part : parts) part->limit_step(limits);
        return StepPlanner(scene, effects, std::move(limits));
    }

    /// Velocities at n ± 1/2, everything else at n. Rates of density are taken half-way, at the positions that belong
    /// to the velocities; forces are those of the end of the last step.
    ///   staggered Euler [Antoci2007]: between steps velocities stand at n − 1/2
    ///   kick-drift-kick: they are brought on to n, where the output sees them
    /// Viscous forces are those of the velocities at n − 1/2 in either, of first order in Δt.
    ///
    /// With more than one sub-step the solid goes through the step at its own rate: a hypoelastic one under the fluid's
    /// force of time n, a total-Lagrangian one under half of that step's impulse before it and half of the next one's
    /// after it, less what is steady in them, which acts all the time (engine/step/parts/steady_load.hpp); the fluid's
    /// continuity then sees the solid's mean velocity over the step, at its place half-way. So both sides exchange the
    /// same momentum f Δt, and the work f · Δx that the solid takes up is the one that belongs to the motion that the
    /// fluid sees. With one sub-step and staggered Euler this is the paper's scheme.
    void step() {
        begin();
        guarded([&] { each_part(&Part<Dim>::first_half); });
        each_part(&Part<Dim>::rates);
        each_coupling(&Coupling<Dim>::rates);
        each_part(&Part<Dim>::second_half);
        end();
        update_neighbors();
        forces();
        each_part(&Part<Dim>::last_kick);
    }

    void begin() {
        if (context.steps > 0) context.plan = planner.next(context.flow.now, context.flow.acceleration);
        const double dt = context.plan.dt;
        context.end = planner.adaptive() ? context.time + dt : static_cast<double>(context.steps + 1) * dt;
        context.motion = {};
    }

    void end() {
        ++context.steps;
        context.time = context.end;
        neighbors.add_motion(std::max(context.motion.fluid, context.motion.wall), context.motion.solid);
    }

    void forces() {
        body_acceleration.update(context.time);
        each_part(&Part<Dim>::forces);
        each_coupling(&Coupling<Dim>::forces);
    }

    void each_part(void (Part<Dim>::*stage)()) {
        for (const auto& part : parts) (*part.*stage)();
    }
    void each_coupling(void (Coupling<Dim>::*stage)()) {
        for (const auto& coupling : context.couplings) (*coupling.*stage)();
    }

    void update_neighbors() {
        const auto scope = context.timer.measure(StepPhase::search);
        guarded([&] { neighbors.update(); });
    }

    /// Turns into a numerical failure: particles that fly apart until their cells cannot be numbered, or that come
    /// where too many mirror walls meet.
    template <class Work>
    void guarded(Work&& work) const {
        const auto broke_down = [this](const char* what, const char* cause) {
            return NumericalError(fmt::format("the computation broke down: after step {} (t = {:.6g} s) {}{}",
                                              context.steps, context.time, what, cause));
        };
        try {
            work();
        } catch (const TooManyGhostPaths& error) {
            throw broke_down(error.what(), "; walls of kind \"fixed\" can stand where many mirror walls meet");
        } catch (const std::length_error& error) {
            throw broke_down(error.what(),
                             "; something drives them apart: pressures or speeds beyond what sound_speed bears, or too "
                             "long a step (lower method.courant)");
        }
    }

    /// visit(name, member) for what changes during a run, except within parts and couplings, which save it themselves.
    /// Everything else follows from the scene.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("time", context.time), visit("steps", context.steps), visit("solid_steps", context.solid_steps);
        visit("pairs", context.pairs), visit("plan", context.plan), visit("timer", context.timer);
        visit("planner", planner), visit("gravity", state.gravity.c);
        for (const SetId set : all_sets) {
            SetColumns<Dim> columns{state[set]};
            visit(name_of(set), columns);
        }
        visit("neighbors", neighbors);
    }

    PairMethod<Dim> pair_method() const { return {scene.method.precision, smoothing}; }

    Scene scene;
    Effects effects;
    State<Dim> state;
    Smoothing<Dim> smoothing;
    Neighborhood<Dim> neighbors;
    StepContext<Dim> context;
    BodyAcceleration<Dim> body_acceleration;
    std::vector<std::unique_ptr<Part<Dim>>> parts;
    StepPlanner planner;
};

template <int Dim>
Simulation<Dim>::Simulation(const Scene& scene) {
    try {
        impl_ = std::make_unique<Impl>(scene);
    } catch (const TooManyGhostPaths& error) {
        scene.fail("walls",
                   fmt::format("found {} walls, and {}; expected fewer mirror walls within a support, or a wall "
                               "of kind \"fixed\" in their place",
                               scene.walls.size(), error.what()));
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
    return impl_->context.time;
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
const MaterialList& Simulation<Dim>::solid_materials() const {
    return impl_->state.solid_materials;
}
template <int Dim>
const PartRange& Simulation<Dim>::hyperelastic() const {
    return impl_->state.hyperelastic;
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
    const StepContext<Dim>& c = impl_->context;
    std::uint64_t builds = impl_->neighbors.builds();
    for (const auto& coupling : c.couplings) builds += coupling->builds();
    return {c.steps, c.steps * c.state.fluid.owned + c.solid_steps * c.state.solid.owned, c.pairs, builds};
}
template <int Dim>
const PhaseTimer& Simulation<Dim>::timer() const {
    return impl_->context.timer;
}
template <int Dim>
EnergyBalance Simulation<Dim>::energy() const {
    EnergyBalance e;
    for (const auto& part : impl_->parts) part->add_energy(e);
    for (const auto& coupling : impl_->context.couplings) coupling->add_energy(e);
    return e;
}
template <int Dim>
Vec<Dim> Simulation<Dim>::momentum() const {
    Vec<Dim> sum;
    for (const auto& part : impl_->parts) sum += part->momentum();
    return sum;
}

template <int Dim>
Vec<Dim> Simulation<Dim>::force_on(std::size_t body) const {
    Vec<Dim> sum;
    for (const auto& coupling : impl_->context.couplings) sum += coupling->fluid_force_on(body);
    return sum;
}
template <int Dim>
Vec<Dim> Simulation<Dim>::contact_force_on(std::size_t body) const {
    Vec<Dim> sum;
    for (const auto& coupling : impl_->context.couplings) sum += coupling->contact_force_on(body);
    return sum;
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
    for (const auto& coupling : impl_->context.couplings)
        if (const InterfaceBalance* balance = coupling->balance()) return *balance;
    return {};
}
template <int Dim>
double Simulation<Dim>::max_speed() const {
    return impl_->context.flow.highest;
}
template <int Dim>
double Simulation<Dim>::max_mach() const {
    double slowest = HUGE_VAL;
    for (const MaterialConstants& fluid : impl_->state.fluid_materials)
        slowest = std::min(slowest, fluid.eos.sound_speed);
    return max_speed() / slowest;
}
template <int Dim>
std::size_t Simulation<Dim>::memory_bytes() const {
    const auto& s = impl_->state;
    std::size_t bytes = s.surface.bytes() + impl_->neighbors.bytes();
    for (const auto& coupling : impl_->context.couplings) bytes += coupling->bytes();
    for (const SetId set : all_sets) bytes += bytes_of(s[set]);
    return bytes;
}
template <int Dim>
const IdIndex& Simulation<Dim>::solid_index_of_id() const {
    return impl_->neighbors.solid_index_of_id();
}

template <int Dim>
std::shared_ptr<const void> Simulation<Dim>::part_with(const void* column) {
    std::shared_ptr<const void> memory;
    const auto look = [&](const ColumnInfo&, auto& values) {
        using Values = std::remove_reference_t<decltype(values)>;
        if (values.empty() || values.data() != column) return;
        const auto parted = std::make_shared<const Values>(std::move(values));
        values = *parted;
        memory = parted;
    };
    for (const SetId set : {SetId::fluid, SetId::solid, SetId::wall}) for_each_array(impl_->state[set], look);
    return memory;
}

template <int Dim>
void Simulation<Dim>::save(const StateWriter& writer) const {
    impl_->visit_state(writer);
    for (const auto& part : impl_->parts) part->save(writer);
    for (const auto& coupling : impl_->context.couplings) coupling->save(writer);
}
template <int Dim>
void Simulation<Dim>::restore(const StateReader& reader) {
    impl_->visit_state(reader);
    for (const auto& part : impl_->parts) part->restore(reader);
    for (const auto& coupling : impl_->context.couplings) coupling->restore(reader);
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace sluice
