#include "engine/step/total_lagrangian_solid.hpp"

#include <algorithm>
#include <cmath>

#include "engine/step/largest_eigenvalue.hpp"
#include "engine/step/solid_motion.hpp"
#include "engine/step/steady_load.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// Up to here the steps that viscosity takes away are less than what the usual Courant number leaves.
constexpr double modest_viscosity = 0.1;

}  // namespace

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
    const double stiffness = c_.has(Effect::hourglass_control) ? m.hourglass_control * 2 * law_.mu : 0.0;
    elastic_correction<Dim>(view_of(solid), c_.neighbors.solid_solid, stiffness, c_.method,
                            solid.gradient_correction, solid.hourglass_stiffness);
    if (c_.has(Effect::clamp_extension)) {
        const double h = *std::max_element(solid.smoothing_length.begin(), solid.smoothing_length.end());
        behind_clamp_ = {c_.scene, solid, c_.neighbors.solid_solid,
                         Smoothing<Dim>(c_.scene.method.smoothing_function).support * h};
        behind_clamp_.share_energy(solid);
    }
    elastic_forces({});
    c_.neighbors.leave_out_clamped(behind_clamp_.rigid(), behind_clamp_.extended());
    fastest_mode_ = find_fastest_mode();
    if (alpha > modest_viscosity) fastest_damping_ = find_fastest_damping();
    update_stress();
    update_density();
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
        update_stress();
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
    const bool loaded = bears_steady_load(c_);
    parallel_for(solid.owned, [&](std::size_t i) {
        if (solid.clamped[i]) return;
        Vec<Dim> acceleration = solid.acceleration[i] + gravity;
        if (loaded) acceleration += solid.steady_acceleration[i];
        solid.velocity.set(i, solid.velocity[i] + half * acceleration);
    });
}

template <int Dim>
void TotalLagrangianSolid<Dim>::push(double interval) {
    if (!is_coupled(c_)) return;
    const auto scope = c_.timer.measure(StepPhase::update);
    auto& solid = c_.state.solid;
    const bool loaded = bears_steady_load(c_);
    parallel_for(solid.owned, [&](std::size_t i) {
        if (solid.clamped[i]) return;
        Vec<Dim> impulse = solid.interface_acceleration[i];
        if (loaded) impulse -= solid.steady_acceleration[i];
        solid.velocity.set(i, solid.velocity[i] + interval * impulse);
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
void TotalLagrangianSolid<Dim>::update_stress() {
    c_.pairs += elastic_forces(viscosity_);
    contact_.add_forces();
}

template <int Dim>
std::uint64_t TotalLagrangianSolid<Dim>::elastic_forces(const ElasticViscosity& viscosity) {
    auto& solid = c_.state.solid;
    const auto view = view_of(solid);
    behind_clamp_.displace(solid);
    std::uint64_t pairs = 0;
    {
        const auto scope = c_.timer.measure(StepPhase::gradient_pass);
        pairs += elastic_deformation<Dim>(view, c_.neighbors.solid_solid, law_, c_.method, solid.deformation,
                                          solid.corrected_stress);
    }
    const auto scope = c_.timer.measure(StepPhase::solid_pass);
    for (auto& column : solid.acceleration.c) std::fill(column.begin(), column.end(), 0.0);
    pairs += elastic_momentum<Dim>(view, c_.neighbors.moving_solid(), viscosity, c_.method, solid.acceleration);
    behind_clamp_.hand_over(solid);
    return pairs;
}

template <int Dim>
double TotalLagrangianSolid<Dim>::find_fastest_mode() {
    auto& solid = c_.state.solid;
    const std::size_t n = solid.owned;
    // Displacements of 1e-6 h in the mean: linear in six digits, and far above the rounding of positions.
    const double mass = ordered_sum<double>(n, [&](std::size_t i) { return solid.mass[i]; });
    const double amplitude = 1e-6 * solid.smoothing_length[0] * std::sqrt(mass);
    const PhaseTimer timer = c_.timer;
    const VectorField<Dim> start = solid.position;
    const double fastest = largest_eigenvalue(Dim * n, [&](std::span<const double> x, std::span<double> y) {
        // Masses on both sides, so that the operator is symmetric: y = √m a(x/√m).
        parallel_for(n, [&](std::size_t i) {
            Vec<Dim> u;
            for (int k = 0; k < Dim; ++k) u[k] = solid.clamped[i] ? 0.0 : x[Dim * i + static_cast<std::size_t>(k)];
            solid.position.set(i, start[i] + (amplitude / std::sqrt(solid.mass[i])) * u);
        });
        elastic_forces({});
        parallel_for(n, [&](std::size_t i) {
            const double scale = solid.clamped[i] ? 0.0 : -std::sqrt(solid.mass[i]) / amplitude;
            for (int k = 0; k < Dim; ++k) y[Dim * i + static_cast<std::size_t>(k)] = scale * solid.acceleration[i][k];
        });
    });
    solid.position = start;
    c_.timer = timer;
    return std::sqrt(fastest);
}

template <int Dim>
double TotalLagrangianSolid<Dim>::find_fastest_damping() {
    auto& solid = c_.state.solid;
    const std::size_t n = solid.owned;
    const PhaseTimer timer = c_.timer;
    const VectorField<Dim> start = solid.velocity;
    // Pairs that approach for v, and those that approach for −v; what is elastic cancels.
    const auto decelerate = [&](std::span<const double> x, std::span<double> y, double sign) {
        parallel_for(n, [&](std::size_t i) {
            const double scale = solid.clamped[i] ? 0.0 : sign / std::sqrt(solid.mass[i]);
            Vec<Dim> v;
            for (int k = 0; k < Dim; ++k) v[k] = scale * x[Dim * i + static_cast<std::size_t>(k)];
            solid.velocity.set(i, v);
        });
        elastic_forces(viscosity_);
        parallel_for(n, [&](std::size_t i) {
            const double scale = solid.clamped[i] ? 0.0 : -sign * std::sqrt(solid.mass[i]);
            for (int k = 0; k < Dim; ++k) y[Dim * i + static_cast<std::size_t>(k)] += scale * solid.acceleration[i][k];
        });
    };
    const double fastest = largest_eigenvalue(Dim * n, [&](std::span<const double> x, std::span<double> y) {
        std::fill(y.begin(), y.end(), 0.0);
        decelerate(x, y, 1);
        decelerate(x, y, -1);
    });
    solid.velocity = start;
    c_.timer = timer;
    return fastest;
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
    auto& solid = c_.state.solid;
    ScalarField energy(solid.owned);
    behind_clamp_.displace(solid);
    sluice::hourglass_energy<Dim>(view_of(solid), c_.neighbors.solid_solid, c_.method, energy);
    behind_clamp_.put_back(solid);
    return ordered_sum<double>(solid.owned, [&](std::size_t i) { return energy[i]; });
}

template class TotalLagrangianSolid<2>;
template class TotalLagrangianSolid<3>;

}  // namespace sluice
