#include "engine/step/hypoelastic_solid.hpp"

#include <algorithm>

#include "engine/step/material_update.hpp"
#include "engine/step/solid_motion.hpp"
#include "kernels/passes/fluid_passes.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
HypoelasticSolid<Dim>::HypoelasticSolid(StepContext<Dim>& context, SolidContact<Dim>& contact)
    : c_(context), contact_(contact) {
    if (!c_.has(Effect::solid_stress)) return;
    const MediumMethod& m = c_.scene.method.solid;
    terms_ = {c_.has(Effect::solid_viscosity) ? m.artificial_viscosity : 0, c_.state.rubber->eos.sound_speed,
              c_.has(Effect::artificial_stress) ? m.artificial_stress : 0, m.artificial_stress_exponent,
              c_.scene.method.smoothing_length};
    update_solid_stress(c_.state, terms_.artificial_stress);
}

template <int Dim>
double HypoelasticSolid<Dim>::advance() {
    double motion = 0;
    begin_solid_motion(c_);
    for (int s = 0; s < c_.plan.substeps; ++s) {
        if (s > 0) {
            const auto scope = c_.timer.measure(StepPhase::search);
            c_.neighbors.update_solid();
        }
        forces();
        kick();
        filter();
        drift_halfway();
        rates_halfway();
        motion += finish();
    }
    end_solid_motion(c_);
    return motion;
}

template <int Dim>
void HypoelasticSolid<Dim>::forces() {
    auto& solid = c_.state.solid;
    const bool coupled = is_coupled(c_);
    const Vec<Dim> gravity = c_.state.gravity;
    parallel_for(solid.owned, [&](std::size_t i) {
        solid.acceleration.set(i, coupled ? gravity + solid.interface_acceleration[i] : gravity);
    });
    {
        const auto scope = c_.timer.measure(StepPhase::solid_pass);
        c_.pairs +=
            solid_momentum<Dim>(view_of(solid), c_.neighbors.moving_solid(), terms_, c_.method, solid.acceleration);
    }
    contact_.add_forces();
}

template <int Dim>
void HypoelasticSolid<Dim>::kick() {
    const auto scope = c_.timer.measure(StepPhase::update);
    const double interval = 0.5 * (last_dt_ + dt());
    last_dt_ = dt();
    auto& solid = c_.state.solid;
    parallel_for(solid.owned, [&](std::size_t i) {
        if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + interval * solid.acceleration[i]);
    });
}

template <int Dim>
void HypoelasticSolid<Dim>::filter() {
    if (!c_.has(Effect::solid_filter)) return;
    const auto scope = c_.timer.measure(StepPhase::filter_pass);
    auto& solid = c_.state.solid;
    c_.pairs += velocity_filter<Dim>(view_of(solid), c_.neighbors.moving_solid(), c_.scene.method.solid.velocity_filter,
                                     c_.method, solid.velocity_correction);
    parallel_for(solid.owned, [&](std::size_t i) {
        if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + solid.velocity_correction[i]);
    });
}

template <int Dim>
void HypoelasticSolid<Dim>::drift_halfway() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    const double half = 0.5 * dt();
    parallel_for(solid.owned,
                 [&](std::size_t i) { solid.position.set(i, solid.position[i] + half * solid.velocity[i]); });
}

template <int Dim>
void HypoelasticSolid<Dim>::rates_halfway() {
    const auto scope = c_.timer.measure(StepPhase::gradient_pass);
    auto& solid = c_.state.solid;
    std::fill(solid.density_rate.begin(), solid.density_rate.end(), 0.0);
    c_.pairs += solid_rates<Dim>(view_of(solid), c_.neighbors.solid_solid, c_.method, solid.density_rate,
                                 solid.velocity_gradient);
}

/// Returns a bound of how far the particles have moved. [m]
template <int Dim>
double HypoelasticSolid<Dim>::finish() {
    const auto scope = c_.timer.measure(StepPhase::update);
    const double motion = dt() * finish_solid_step(c_.state, terms_.artificial_stress, dt());
    c_.neighbors.add_solid_motion(motion);
    contact_.add_motion(motion);
    return motion;
}

template class HypoelasticSolid<2>;
template class HypoelasticSolid<3>;

}  // namespace sluice
