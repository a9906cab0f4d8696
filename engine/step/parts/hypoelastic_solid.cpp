#include "engine/step/parts/hypoelastic_solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/files/state_visitors.hpp"
#include "engine/step/balances.hpp"
#include "engine/step/coupling.hpp"
#include "engine/step/parts/resting.hpp"
#include "engine/step/parts/solid_motion.hpp"
#include "kernels/materials/jaumann.hpp"
#include "kernels/materials/tensile_correction.hpp"
#include "kernels/passes/fluid_passes.hpp"

namespace sluice {
namespace {

/// p, σ/ρ² and, where `artificial_stress` e is not 0 and there is tension, R from density and S.
template <int Dim>
void set_stress(ParticleSet<Dim>& solid, const EquationOfState& eos, double artificial_stress, std::size_t i) {
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

}  // namespace

template <int Dim>
HypoelasticSolid<Dim>::HypoelasticSolid(StepContext<Dim>& context)
    : c_(context),
      all_(context.neighbors.pair(
          {SetId::solid, SetId::solid, Upkeep::with_solid, Targets::own, Reach::mean, context.state.hypoelastic})) {
    const MediumMethod& m = c_.scene.method.solid;
    terms_ = {c_.has(Effect::solid_viscosity) ? m.artificial_viscosity : 0,
              c_.state.solid_materials.front().eos.sound_speed,
              c_.has(Effect::artificial_stress) ? m.artificial_stress : 0, m.artificial_stress_exponent,
              c_.scene.method.smoothing_length, c_.has(Effect::several_solids)};
    if (!c_.has(Effect::clamp)) return;
    moving_ = &c_.neighbors.derive(all_, "moving");
    all_.searched = [this] {
        leave_out_resting<Dim>(c_.state.solid, {}, {}, all_.list, moving_->list);
        for (auto& column : c_.state.solid.velocity_gradient.c) std::fill(column.begin(), column.end(), 0.0);
    };
}

template <int Dim>
void HypoelasticSolid<Dim>::start() {
    auto& solid = c_.state.solid;
    with_materials(c_.state.solid_materials, solid.body, [&](const auto& material) {
        parallel_for(part(), [&](std::size_t i) { set_stress(solid, material(i).eos, terms_.artificial_stress, i); });
    });
}

/// The paper takes the speed of compression, √(K/ρ).
template <int Dim>
void HypoelasticSolid<Dim>::limit_step(std::vector<CourantLimit>& limits) const {
    const auto& solid = c_.state.solid;
    for (const MaterialConstants& material : c_.state.solid_materials) {
        double h = std::numeric_limits<double>::infinity();
        for (std::size_t i = part().first; i < part().last; ++i)
            if (c_.state.solid_materials.of_body(solid.body[i]).number == material.number)
                h = std::min(h, solid.smoothing_length[i]);
        if (!std::isfinite(h)) continue;  // of solids of another model
        const double c0 = material.eos.sound_speed;
        limits.push_back(
            {SetId::solid, c_.scene.materials[material.number].name, c_.scene.method.courant * h / c0, h, c0, 0});
    }
}

template <int Dim>
void HypoelasticSolid<Dim>::begin_step() {
    begin_solid_motion(c_, part());
}

template <int Dim>
void HypoelasticSolid<Dim>::end_step() {
    end_solid_motion(c_, part(), FluidPush::within);
}

template <int Dim>
double HypoelasticSolid<Dim>::move(int substep) {
    if (substep > 0) {
        const auto scope = c_.timer.measure(StepPhase::search);
        c_.neighbors.update_solid();
    }
    forces();
    kick();
    filter();
    drift_halfway();
    rates_halfway();
    return drift_to_end();
}

template <int Dim>
void HypoelasticSolid<Dim>::forces() {
    auto& solid = c_.state.solid;
    const bool coupled = is_coupled(c_);
    const Vec<Dim> gravity = c_.state.gravity;
    parallel_for(part(), [&](std::size_t i) {
        solid.acceleration.set(i, coupled ? gravity + solid.interface_acceleration[i] : gravity);
    });
    {
        const auto scope = c_.timer.measure(StepPhase::solid_pass);
        c_.pairs += solid_momentum<Dim>(view_of(solid), moving(), terms_, c_.method, solid.acceleration);
    }
    for (const auto& coupling : c_.couplings) coupling->push_solid(part());
}

template <int Dim>
void HypoelasticSolid<Dim>::kick() {
    const auto scope = c_.timer.measure(StepPhase::update);
    const double interval = 0.5 * (last_dt_ + dt());
    last_dt_ = dt();
    auto& solid = c_.state.solid;
    parallel_for(part(), [&](std::size_t i) {
        if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + interval * solid.acceleration[i]);
    });
}

template <int Dim>
void HypoelasticSolid<Dim>::filter() {
    if (!c_.has(Effect::solid_filter)) return;
    const auto scope = c_.timer.measure(StepPhase::filter_pass);
    auto& solid = c_.state.solid;
    c_.pairs += velocity_filter<Dim>(view_of(solid), moving(), c_.scene.method.solid.velocity_filter, c_.method,
                                     solid.velocity_correction);
    parallel_for(part(), [&](std::size_t i) {
        if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + solid.velocity_correction[i]);
    });
}

template <int Dim>
void HypoelasticSolid<Dim>::drift_halfway() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    const double half = 0.5 * dt();
    parallel_for(part(), [&](std::size_t i) { solid.position.set(i, solid.position[i] + half * solid.velocity[i]); });
}

template <int Dim>
void HypoelasticSolid<Dim>::rates_halfway() {
    const auto scope = c_.timer.measure(StepPhase::gradient_pass);
    auto& solid = c_.state.solid;
    std::fill(solid.density_rate.begin(), solid.density_rate.end(), 0.0);
    c_.pairs += solid_rates<Dim>(view_of(solid), all_.list, c_.method, solid.density_rate, solid.velocity_gradient,
                                 terms_.multiphase ? DensitySum::by_volume : DensitySum::by_mass);
}

/// x += v Δt/2, ρ += dρ/dt Δt, S over the step's velocity gradient (kernels/materials/jaumann.hpp), then the stress.
/// Returns a bound of how far the particles have moved in their step. [m]
template <int Dim>
double HypoelasticSolid<Dim>::drift_to_end() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    const double step = dt();
    const double speed = with_materials(c_.state.solid_materials, solid.body, [&](const auto& material) {
        return std::sqrt(nonnegative_max(part(), [&](std::size_t i) {
            solid.position.set(i, solid.position[i] + 0.5 * step * solid.velocity[i]);
            solid.density[i] += step * solid.density_rate[i];
            advance_stress(solid, material(i).shear_modulus, step, i);
            set_stress(solid, material(i).eos, terms_.artificial_stress, i);
            return norm2(solid.velocity[i]);
        }));
    });
    const double motion = step * speed;
    c_.neighbors.add_solid_motion(motion);
    for (const auto& coupling : c_.couplings) coupling->solid_has_moved(motion);
    return motion;
}

template <int Dim>
void HypoelasticSolid<Dim>::add_energy(EnergyBalance& e) const {
    const auto& solid = c_.state.solid;
    add_motion(solid, part(), c_.state.gravity, e);
    add_compression(solid, part(), c_.state.solid_materials, e);
    e.elastic += with_materials(c_.state.solid_materials, solid.body, [&](const auto& material) {
        return ordered_sum<double>(part(), [&](std::size_t i) {
            const double s2 = contract_deviator<Dim>(sym_to_tensor<Dim>(solid.deviatoric_stress[i]));
            return s2 / (4 * material(i).shear_modulus) * solid.mass[i] / solid.density[i];
        });
    });
}

template <int Dim>
Vec<Dim> HypoelasticSolid<Dim>::momentum() const {
    return momentum_of(c_.state.solid, part());
}

template <int Dim>
void HypoelasticSolid<Dim>::save(const StateWriter& writer) {
    writer("hypoelastic_last_dt", last_dt_);
}
template <int Dim>
void HypoelasticSolid<Dim>::restore(const StateReader& reader) {
    reader("hypoelastic_last_dt", last_dt_);
}

template class HypoelasticSolid<2>;
template class HypoelasticSolid<3>;

}  // namespace sluice
