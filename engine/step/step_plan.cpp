#include "engine/step/step_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/effects.hpp"
#include "engine/errors.hpp"
#include "engine/scene/light_solid.hpp"
#include "engine/particles/state.hpp"

namespace sluice {
namespace {

/// How much shorter the step of a total-Lagrangian solid must be with artificial viscosity α, whose forces lag by half
/// a step: √(1 + ζ²) − ζ of the undamped limit [Belytschko, Liu & Moran 2000, section 6.2.9], ζ the damping ratio of
/// the fastest mode. ζ = α/6 bounds what was measured on a bent, shaken block (h = 1.5 d): stable up to a Courant
/// number of 0.95, 0.9, 0.85, 0.75, 0.5 with α = 0, 0.5, 1, 2, 4. Beside a clamp that cuts cells it is up to four times
/// as large as inside; hence half of the fastest damping, as pairs that part are not damped. (A polygon with a clamp,
/// α = 1: stable up to 0.5 without that.)
double damped_step_ratio(double artificial_viscosity, double fastest_mode, double fastest_damping) {
    const double ratio = std::max(artificial_viscosity / 6, 0.5 * fastest_damping / (2 * fastest_mode));
    return std::sqrt(1 + ratio * ratio) - ratio;
}

/// Bodies in contact are stiffer where they touch than the fastest mode of the bodies alone. Colliding rings run up to
/// 0.85 of its limit and break down at 0.9.
constexpr double contact_step_ratio = 0.85;

}  // namespace

template <int Dim>
std::vector<CourantLimit> courant_limits_of(const Scene& scene, const State<Dim>& state) {
    std::vector<CourantLimit> limits;
    const auto add = [&](const ParticleSet<Dim>& phase, const std::optional<Medium>& medium, double sound_speed,
                         double share) {
        const double h = *std::min_element(phase.smoothing_length.begin(), phase.smoothing_length.end());
        const double nu = medium->viscosity;
        const double dt = share * scene.method.courant * h / sound_speed;
        limits.push_back({medium->name, nu > 0 ? std::min(dt, 0.125 * h * h / nu) : dt, h, sound_speed, nu});
    };
    if (state.water) add(state.fluid, state.water, state.water->eos.sound_speed, light_solid(scene).step_share);
    if (!state.rubber) return limits;
    // The paper takes the speed of compression, √(K/ρ); nothing holds the fastest waves back in the other solid.
    const bool reference = state.solid.deformation.size() > 0;
    const Medium& rubber = *state.rubber;
    const double fastest = std::sqrt(rubber.law.wave_modulus() / rubber.eos.density);
    add(state.solid, state.rubber, reference ? fastest : rubber.eos.sound_speed, 1);
    return limits;
}

void limit_by_mode(const Scene& scene, const Effects& effects, double fastest_mode, double fastest_damping,
                   CourantLimit& limit) {
    if (!(fastest_mode > 0)) return;
    limit.dt = scene.method.courant * 2 / fastest_mode;
    if (effects.has(Effect::contact)) limit.dt *= contact_step_ratio;
    if (effects.has(Effect::solid_viscosity))
        limit.dt *= damped_step_ratio(scene.method.solid.artificial_viscosity, fastest_mode, fastest_damping);
}

StepPlanner::StepPlanner(const Scene& scene, const Effects& effects, std::vector<CourantLimit> limits)
    : limits_(std::move(limits)),
      adaptive_(effects.has(Effect::adaptive_step)),
      multi_rate_(effects.has(Effect::solid_substeps)),
      stated_(scene.method.time_step.value_or(0)) {}

StepPlan StepPlanner::next(double speed, double acceleration) {
    double fluid = share_ * limits_.front().dt;
    if (adaptive_) {
        const CourantLimit& limit = limits_.front();
        fluid *= limit.sound_speed / (limit.sound_speed + speed);
        if (acceleration > 0) fluid = std::min(fluid, share_ * 0.25 * std::sqrt(limit.h / acceleration));
    }
    const double solid = share_ * limits_.back().dt, least = std::min(fluid, solid);
    double dt = stated_ > 0 ? share_ * stated_ : multi_rate_ ? fluid : least;
    if (adaptive_ && last_ > 0) dt = std::min(dt, 1.1 * last_);
    if (!std::isfinite(dt))
        throw NumericalError(fmt::format(
            "found no time step: the fastest particle moves at {:.3g} m/s and is accelerated by {:.3g} m/s2; look for "
            "a pressure, a density or a hydrostatic_surface of the scene that is beyond reason",
            speed, acceleration));
    last_ = dt;
    if (!multi_rate_) return {dt};
    const int substeps = std::max(1, static_cast<int>(std::ceil(dt / solid * (1 - 1e-12))));
    return {dt, substeps, std::max(1.0, dt / least)};
}

template std::vector<CourantLimit> courant_limits_of<2>(const Scene&, const State<2>&);
template std::vector<CourantLimit> courant_limits_of<3>(const Scene&, const State<3>&);

}  // namespace sluice
