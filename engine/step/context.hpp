// What all parts of a step share.
#pragma once

#include "engine/effects.hpp"
#include "engine/particles/state.hpp"
#include "engine/step/neighborhood.hpp"
#include "engine/step/phase_timer.hpp"
#include "engine/step/step_plan.hpp"
#include "kernels/pairs/block_loop.hpp"
#include "kernels/pairs/particle_view.hpp"

namespace sluice {

template <int Dim>
struct StepContext {
    const Scene& scene;
    const Effects& effects;
    State<Dim>& state;
    Neighborhood<Dim>& neighbors;
    PairMethod<Dim> method;
    StepPlan plan;  ///< of the step under way
    PhaseTimer timer{};
    std::uint64_t pairs = 0;  ///< directed pairs inside the support so far, over all passes

    bool has(Effect e) const { return effects.has(e); }
};

}  // namespace sluice
