// The steady part of the fluid's load on a solid that takes steps of its own.
//
// The load f^n is known once per step of the fluid. As an impulse ½Δt f^n before the solid's own steps and ½Δt f^(n+1)
// behind them it is kick-drift-kick for what moves slowly, but a mode of angular frequency ω is struck once per Δt by
// a load that in fact rests on it, and stands, where the steps begin and end, not at x₀ = f/(m ω²) but at
//   x₀ (ωΔt/2) cot(ωΔt/2)
// the fixed point of kick, free motion and kick. That is x₀ (1 − (ωΔt)²/12) for a slow mode, and any number as Δt
// comes near to one of its periods: the third symmetric bending mode of a stiff plate is soon there. So the load's mean
// f̄ acts all the time, and only what differs from it as an impulse:
//   ½Δt (f^n − f̄^n), n_s steps under elastic forces and f̄^n, ½Δt (f^(n+1) − f̄^n)
// In sum it is the same impulse, and a load at rest is borne exactly. f̄ goes so slowly that stability is that of
// impulses: held for a step as a whole, f^n would do work on waves that it lags behind.
#pragma once

#include "engine/step/context.hpp"

namespace sluice {

/// f̄ is a running mean over about this many steps.
inline constexpr double steady_load_steps = 32;

/// Whether f̄ acts within the solid's own steps: with a single one, there is nothing within.
template <int Dim>
bool bears_steady_load(const StepContext<Dim>& c) {
    return c.has(Effect::steady_load) && c.plan.substeps > 1;
}

template <int Dim>
void follow_steady_load(StepContext<Dim>& c, const PartRange& part) {
    if (!c.has(Effect::steady_load)) return;
    auto& solid = c.state.solid;
    // The first load counts as steady.
    if (c.steps == 0) solid.steady_acceleration = solid.interface_acceleration;
    parallel_for(part, [&](std::size_t i) {
        const Vec<Dim> mean = solid.steady_acceleration[i];
        solid.steady_acceleration.set(i, mean + (1 / steady_load_steps) * (solid.interface_acceleration[i] - mean));
    });
}

}  // namespace sluice
