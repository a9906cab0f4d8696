// What all parts and couplings of a step share.
#pragma once

#include <memory>
#include <vector>

#include "engine/particles/state.hpp"
#include "engine/scene/rules/effects.hpp"
#include "engine/step/neighborhood.hpp"
#include "engine/step/phase_timer.hpp"
#include "engine/step/step_plan.hpp"
#include "kernels/pairs/block_loop.hpp"
#include "kernels/pairs/particle_view.hpp"

namespace sluice {

template <int Dim>
class Coupling;

/// How fast the fluid is, for the length of steps and for reports.
struct FlowSpeed {
    double now = 0;           ///< highest |v| of the last step [m/s]
    double highest = 0;       ///< of all steps so far [m/s]
    double acceleration = 0;  ///< highest |a| of the last kick [m/s²]
};

/// Upper bounds of how far particles move in the current step. [m]
struct StepMotion {
    double fluid = 0, wall = 0, solid = 0;
};

template <int Dim>
struct StepContext {
    const Scene& scene;
    const Effects& effects;
    State<Dim>& state;
    Neighborhood<Dim>& neighbors;
    PairMethod<Dim> method;
    StepPlan plan;  ///< of the current step
    PhaseTimer timer{};
    std::uint64_t steps = 0;        ///< taken so far
    std::uint64_t solid_steps = 0;  ///< steps of the solids' own, so far
    double time = 0, end = 0;       ///< at which the current step begins and ends [s]
    std::uint64_t pairs = 0;        ///< directed pairs inside the support so far, over all passes
    FlowSpeed flow{};
    StepMotion motion{};
    std::vector<Vec<Dim>> wall_acceleration{};  ///< by the walls' numbers, if one moves [m/s²]
    std::vector<std::unique_ptr<Coupling<Dim>>> couplings{};

    bool has(Effect e) const { return effects.has(e); }
};

}  // namespace sluice
