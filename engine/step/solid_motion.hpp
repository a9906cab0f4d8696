// What the fluid sees of a solid that went through a step at its own rate: its mean velocity, at its place half-way.
#pragma once

#include "engine/step/context.hpp"

namespace sluice {

/// Remembers where the solid stands, if it meets a fluid.
template <int Dim>
void begin_solid_motion(StepContext<Dim>& c) {
    if (c.has(Effect::interface_force)) c.state.solid.halfway_position = c.state.solid.position;
}

template <int Dim>
void end_solid_motion(StepContext<Dim>& c) {
    if (!c.has(Effect::interface_force)) return;
    auto& solid = c.state.solid;
    for (std::size_t i = 0; i < solid.owned; ++i) {
        const Vec<Dim> before = solid.halfway_position[i], after = solid.position[i];
        solid.halfway_position.set(i, 0.5 * (before + after));
        solid.mean_velocity.set(i, (1 / c.plan.dt) * (after - before));
    }
}

}  // namespace sluice
