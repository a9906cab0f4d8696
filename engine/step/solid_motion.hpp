// What the fluid sees of a solid that went through a step at its own rate: its mean velocity, at its place half-way.
#pragma once

#include "engine/step/context.hpp"
#include "engine/step/steady_load.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

/// Whether the solid meets a fluid.
template <int Dim>
bool is_coupled(const StepContext<Dim>& c) {
    return c.has(Effect::interface_force) || c.has(Effect::moving_boundary);
}

/// Remembers where the solid stands and how fast it is, if it meets a fluid.
template <int Dim>
void begin_solid_motion(StepContext<Dim>& c) {
    auto& solid = c.state.solid;
    if (is_coupled(c)) solid.halfway_position = solid.position;
    if (c.has(Effect::moving_boundary)) solid.mean_acceleration = solid.velocity;  // until the step's end
}

template <int Dim>
void end_solid_motion(StepContext<Dim>& c) {
    if (!is_coupled(c)) return;
    auto& solid = c.state.solid;
    parallel_for(solid.owned, [&](std::size_t i) {
        const Vec<Dim> before = solid.halfway_position[i], after = solid.position[i];
        solid.halfway_position.set(i, 0.5 * (before + after));
        solid.mean_velocity.set(i, (1 / c.plan.dt) * (after - before));
    });
    if (!c.has(Effect::moving_boundary)) return;
    // A total-Lagrangian solid is pushed by the fluid before and after its own steps; in them only a steady load acts.
    const bool pushed = c.has(Effect::total_lagrangian), loaded = bears_steady_load(c);
    parallel_for(solid.owned, [&](std::size_t i) {
        Vec<Dim> mean = (1 / c.plan.dt) * (solid.velocity[i] - solid.mean_acceleration[i]);
        if (pushed && !solid.clamped[i]) mean += solid.interface_acceleration[i];
        if (loaded && !solid.clamped[i]) mean -= solid.steady_acceleration[i];
        solid.mean_acceleration.set(i, mean);
    });
}

}  // namespace sluice
