#include "engine/step/total_lagrangian_solid.hpp"

#include <algorithm>
#include <cmath>

#include "engine/step/solid_motion.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
TotalLagrangianSolid<Dim>::TotalLagrangianSolid(StepContext<Dim>& context, SolidContact<Dim>& contact)
    : c_(context), contact_(contact) {
    if (!c_.has(Effect::total_lagrangian)) return;
    const Medium& medium = *c_.state.rubber;
    const MediumMethod& m = c_.scene.method.solid;
    auto& solid = c_.state.solid;
    law_ = medium.law;
    const double alpha = c_.has(Effect::solid_viscosity) ? m.artificial_viscosity : 0.0;
    viscosity_ = {alpha, medium.eos.sound_speed, medium.eos.density};
    const double stiffness = c_.has(Effect::hourglass_control) ? m.hourglass_control * law_.young_modulus() : 0.0;
    elastic_correction<Dim>(reference_view_of(solid), c_.neighbors.solid_solid, stiffness, c_.method,
                            solid.gradient_correction, solid.hourglass_stiffness);
    update_stress(c_.neighbors.solid_solid);
    update_density();
    c_.neighbors.leave_out_clamped();
}

template <int Dim>
double TotalLagrangianSolid<Dim>::advance() {
    begin_solid_motion(c_);
    const bool all_clamped = c_.neighbors.moving_solid().size() == 0;
    const double motion = all_clamped ? 0 : move();
    end_solid_motion(c_);
    return motion;
}

template <int Dim>
double TotalLagrangianSolid<Dim>::move() {
    double motion = 0;
    for (int s = 0; s < c_.plan.substeps; ++s) {
        kick();
        const double moved = drift();
        contact_.add_motion(moved);
        motion += moved;
        update_stress(c_.neighbors.moving_solid());
        kick();
    }
    update_density();
    return motion;
}

template <int Dim>
void TotalLagrangianSolid<Dim>::kick() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    const Vec<Dim> gravity = c_.state.gravity;
    const double half = 0.5 * dt();
    parallel_for(solid.owned, [&](std::size_t i) {
        if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + half * (solid.acceleration[i] + gravity));
    });
}

template <int Dim>
void TotalLagrangianSolid<Dim>::push(double interval) {
    if (!is_coupled(c_)) return;
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    parallel_for(solid.owned, [&](std::size_t i) {
        if (!solid.clamped[i]) solid.velocity.set(i, solid.velocity[i] + interval * solid.interface_acceleration[i]);
    });
}

template <int Dim>
double TotalLagrangianSolid<Dim>::drift() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    const double step = dt();
    return step * std::sqrt(nonnegative_max(solid.owned, [&](std::size_t i) {
               const Vec<Dim> v = solid.velocity[i];
               solid.position.set(i, solid.position[i] + step * v);
               return norm2(v);
           }));
}

template <int Dim>
void TotalLagrangianSolid<Dim>::update_stress(const NeighborList& accelerated) {
    auto& solid = c_.state.solid;
    const auto view = reference_view_of(solid);
    {
        const auto scope = c_.timer.measure(StepPhase::gradient_pass);
        c_.pairs += elastic_deformation<Dim>(view, c_.neighbors.solid_solid, law_, c_.method, solid.deformation,
                                             solid.corrected_stress);
    }
    {
        const auto scope = c_.timer.measure(StepPhase::solid_pass);
        for (auto& column : solid.acceleration.c) std::fill(column.begin(), column.end(), 0.0);
        c_.pairs += elastic_momentum<Dim>(view, accelerated, viscosity_, c_.method, solid.acceleration);
    }
    contact_.add_forces();
}

template <int Dim>
void TotalLagrangianSolid<Dim>::update_density() {
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    parallel_for(solid.owned, [&](std::size_t i) {
        const double j = tensor_of<Dim>(solid.deformation[i]).determinant();
        solid.density[i] = solid.mass[i] / (solid.volume[i] * std::max(j, Hyperelastic::expansion_volume));
    });
}

template <int Dim>
double TotalLagrangianSolid<Dim>::hourglass_energy() const {
    if (!c_.has(Effect::hourglass_control)) return 0;
    const auto& solid = c_.state.solid;
    ScalarField energy(solid.owned);
    sluice::hourglass_energy<Dim>(reference_view_of(solid), c_.neighbors.solid_solid, c_.method, energy);
    return ordered_sum<double>(solid.owned, [&](std::size_t i) { return energy[i]; });
}

template class TotalLagrangianSolid<2>;
template class TotalLagrangianSolid<3>;

}  // namespace sluice
