#include "engine/step/step_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/errors.hpp"
#include "engine/scene/rules/effects.hpp"

namespace sluice {

StepPlanner::StepPlanner(const Scene& scene, const Effects& effects, std::vector<CourantLimit> limits)
    : limits_(std::move(limits)),
      adaptive_(effects.has(Effect::adaptive_step)),
      multi_rate_(effects.has(Effect::solid_substeps)),
      stated_(scene.method.time_step.value_or(0)) {
    check(scene);
}

bool StepPlanner::has(SetId set) const {
    return std::any_of(limits_.begin(), limits_.end(), [&](const CourantLimit& l) { return l.set == set; });
}

double StepPlanner::smallest_limit(SetId set) const {
    const bool any = has(set);
    double least = std::numeric_limits<double>::infinity();
    for (const CourantLimit& limit : limits_)
        if (!any || limit.set == set) least = std::min(least, limit.dt);
    return least;
}

/// Constants that are valid one by one may still give a zero, non-finite or absurdly small time step.
void StepPlanner::check(const Scene& scene) const {
    constexpr double most_steps = 1e15;    // a longer time and its next step are the same number
    constexpr double most_substeps = 1e6;  // of seconds each, for a hundred thousand particles
    double least = stated_ > 0 ? stated_ : std::numeric_limits<double>::infinity();
    for (const CourantLimit& limit : limits_) {
        if (!(limit.dt > 0) || !std::isfinite(limit.dt))
            scene.fail("materials." + limit.medium,
                       fmt::format("found constants that make a time step of {} s, expected a number > 0", limit.dt));
        if (!(stated_ > 0)) least = std::min(least, limit.dt);
    }
    if (scene.output.end / least > most_steps)
        scene.fail("output.end",
                   fmt::format("found {} s, which takes {:.2g} steps of {:.2g} s, expected {} at the most",
                               scene.output.end, scene.output.end / least, least, most_steps));
    if (!multi_rate_) return;
    const double dt = stated_ > 0 ? stated_ : smallest_limit(SetId::fluid);
    for (const CourantLimit& limit : limits_)
        if (limit.set == SetId::solid && dt / limit.dt > most_substeps)
            scene.fail(
                "materials." + limit.medium,
                fmt::format("found a solid that takes {:.2g} steps in each step of {:.2g} s, expected {} at the most",
                            dt / limit.dt, dt, most_substeps));
}

StepPlan StepPlanner::next(double speed, double acceleration) {
    const double solid = share_ * smallest_limit(SetId::solid);
    const SetId leading = has(SetId::fluid) ? SetId::fluid : SetId::solid;
    double fluid = share_ * smallest_limit(leading);
    if (adaptive_) {
        fluid = std::numeric_limits<double>::infinity();
        for (const CourantLimit& limit : limits_) {
            if (limit.set != leading) continue;
            double dt = share_ * limit.dt;
            dt *= limit.sound_speed / (limit.sound_speed + speed);
            if (acceleration > 0) dt = std::min(dt, share_ * 0.25 * std::sqrt(limit.h / acceleration));
            fluid = std::isnan(dt) ? dt : std::min(fluid, dt);
        }
    }
    const double least = std::min(fluid, solid);
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

}  // namespace sluice
