#include "engine/step/step_plan.hpp"

#include <algorithm>
#include <cmath>

#include "engine/state/state.hpp"

namespace sluice {

template <int Dim>
std::vector<CourantLimit> courant_limits_of(const Scene& scene, const State<Dim>& state) {
    std::vector<CourantLimit> limits;
    const auto add = [&](const PhaseBase<Dim>& phase, const std::optional<Medium>& medium) {
        if (!medium) return;
        const auto& h = phase.smoothing_length;
        limits.push_back(
            {medium->name, scene.method.courant * *std::min_element(h.begin(), h.end()) / medium->eos.sound_speed});
    };
    add(state.fluid, state.water);
    add(state.solid, state.rubber);
    return limits;
}

StepPlan plan_steps(const Scene& scene, const std::vector<CourantLimit>& limits, bool both_media) {
    const auto least =
        std::min_element(limits.begin(), limits.end(), [](const auto& a, const auto& b) { return a.dt < b.dt; });
    const bool multi_rate = scene.method.multi_rate && both_media;
    const double dt = scene.method.time_step.value_or(multi_rate ? limits.front().dt : least->dt);
    if (!multi_rate) return {dt};
    const int substeps = std::max(1, static_cast<int>(std::ceil(dt / limits.back().dt * (1 - 1e-12))));
    return {dt, substeps, std::max(1.0, dt / least->dt)};
}

template std::vector<CourantLimit> courant_limits_of<2>(const Scene&, const State<2>&);
template std::vector<CourantLimit> courant_limits_of<3>(const Scene&, const State<3>&);

}  // namespace sluice
