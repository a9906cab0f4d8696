// What the fluid sees of a solid that has taken a step at its own rate: its mean velocity, at its half-way position.
#pragma once

#include "engine/step/context.hpp"
#include "engine/step/parts/steady_load.hpp"

namespace sluice {

/// Whether the solids meet a fluid.
template <int Dim>
bool is_coupled(const StepContext<Dim>& c) {
    return c.has(Effect::interface_force) || c.has(Effect::moving_boundary);
}

/// Stores a solid's position and velocity at the start of the step, if it meets a fluid.
template <int Dim>
void begin_solid_motion(StepContext<Dim>& c, const PartRange& part) {
    auto& solid = c.state.solid;
    const auto copy = [&](const VectorField<Dim>& from, VectorField<Dim>& to) {
        for (std::size_t k = 0; k < Dim; ++k)
            std::copy(from.c[k].begin() + static_cast<std::ptrdiff_t>(part.first),
                      from.c[k].begin() + static_cast<std::ptrdiff_t>(part.last),
                      to.c[k].begin() + static_cast<std::ptrdiff_t>(part.first));
    };
    if (is_coupled(c)) copy(solid.position, solid.halfway_position);
    if (c.has(Effect::moving_boundary)) copy(solid.velocity, solid.mean_acceleration);  // until the step's end
}

/// When the fluid's force acts on a solid: within its own steps, or before and after them, when only the steady part of
/// it acts within.
enum class FluidPush { within, before_and_after };

template <int Dim>
void end_solid_motion(StepContext<Dim>& c, const PartRange& part, FluidPush push) {
    if (!is_coupled(c)) return;
    auto& solid = c.state.solid;
    parallel_for(part, [&](std::size_t i) {
        const Vec<Dim> before = solid.halfway_position[i], after = solid.position[i];
        solid.halfway_position.set(i, 0.5 * (before + after));
        solid.mean_velocity.set(i, (1 / c.plan.dt) * (after - before));
    });
    if (!c.has(Effect::moving_boundary)) return;
    const bool pushed = push == FluidPush::before_and_after, loaded = pushed && bears_steady_load(c);
    parallel_for(part, [&](std::size_t i) {
        Vec<Dim> mean = (1 / c.plan.dt) * (solid.velocity[i] - solid.mean_acceleration[i]);
        if (pushed && !solid.clamped[i]) mean += solid.interface_acceleration[i];
        if (loaded && !solid.clamped[i]) mean -= solid.steady_acceleration[i];
        solid.mean_acceleration.set(i, mean);
    });
}

}  // namespace sluice
