#include "engine/simulation.hpp"

#include <stdexcept>

#include "engine/errors.hpp"
#include "engine/state/visit.hpp"
#include "engine/step/balances.hpp"
#include "engine/step/context.hpp"
#include "engine/step/fluid.hpp"
#include "engine/step/hypoelastic_solid.hpp"
#include "engine/step/interface_coupling.hpp"
#include "engine/step/walls.hpp"

namespace sluice {

template <int Dim>
struct Simulation<Dim>::Impl {
    explicit Impl(const Scene& s)
        : scene(s),
          effects(scene),
          state(place_particles<Dim>(scene, effects)),
          limits(courant_limits_of(scene, state)),
          neighbors(state, effects, scene.method.smoothing_length),
          context{scene,
                  effects,
                  state,
                  neighbors,
                  scene.method.precision == "mixed" ? Precision::mixed : Precision::full,
                  plan_steps(scene, limits, state.water && state.rubber)},
          fluid(context),
          walls(context),
          solid(context),
          interface(context) {
        const double dt = context.plan.dt, of_solid = highest_speed(state.solid);
        neighbors.expect_motion(dt * fluid.max_speed(), dt * of_solid, dt / context.plan.substeps * of_solid);
        update_neighbors();
        forces();
    }

    /// Velocities at n ± 1/2, everything else at n [Antoci2007]. Rates of density and stress are taken half-way, at the
    /// positions that belong to the velocities. Forces are those of the end of the last step.
    ///
    /// With more than one sub-step the solid goes through the step at its own rate under the interface's force of
    /// time n; the fluid's continuity then sees the solid's mean velocity over the step, at its place half-way. So both
    /// sides exchange the same momentum f Δt, and the work f · Δx that the solid takes up is the one that belongs to
    /// the motion that the fluid sees. With one sub-step this is the paper's scheme.
    void step() {
        fluid.kick(steps == 0 ? 0.5 * context.plan.dt : context.plan.dt);  // the first brings v from time 0 to 1/2
        fluid.filter();
        fluid.drift_halfway();
        const double solid_motion = effects.has(Effect::solid_stress) ? advance_solid() : 0.0;
        rates();
        const double fluid_motion = fluid.finish();
        neighbors.add_motion(fluid_motion, solid_motion);
        update_neighbors();
        forces();
        ++steps;
    }

    void forces() {
        fluid.forces();
        walls.forces();
        if (effects.has(Effect::interface_force)) interface.forces();
    }

    void rates() {
        fluid.rates();
        walls.rates();
        if (effects.has(Effect::interface_force)) interface.rates();
    }

    double advance_solid() {
        return guarded([&] { return solid.advance(); });
    }
    void update_neighbors() {
        const auto scope = context.timer.measure(StepPhase::search);
        guarded([&] { return neighbors.update(), 0; });
    }

    /// Particles that fly apart until their cells cannot be numbered are a numerical failure.
    template <class Work>
    static auto guarded(Work&& work) {
        try {
            return work();
        } catch (const std::length_error& error) {
            throw NumericalError(error.what());
        }
    }

    Scene scene;
    Effects effects;
    State<Dim> state;
    std::vector<CourantLimit> limits;
    Neighborhood<Dim> neighbors;
    StepContext<Dim> context;
    FluidPart<Dim> fluid;
    WallPart<Dim> walls;
    HypoelasticSolid<Dim> solid;
    InterfaceCoupling<Dim> interface;
    std::uint64_t steps = 0;
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
    return static_cast<double>(impl_->steps) * impl_->context.plan.dt;
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
    const auto& [steps, substeps] = std::pair(impl_->steps, static_cast<std::uint64_t>(impl_->context.plan.substeps));
    const std::uint64_t moved = impl_->state.fluid.owned + substeps * impl_->state.solid.owned;
    return {steps, steps * moved, impl_->context.pairs, impl_->neighbors.builds()};
}
template <int Dim>
const PhaseTimer& Simulation<Dim>::timer() const {
    return impl_->context.timer;
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
    return impl_->interface.balance();
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
