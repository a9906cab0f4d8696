// What a scene and each of its effects cost, measured.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/rules/effect_fields.hpp"
#include "engine/scene/rules/effects.hpp"
#include "engine/step/phase_timer.hpp"

namespace sluice {

/// Phases of a step that run for this effect where a scene cannot do without it; empty if it runs within those of
/// others.
std::vector<StepPhase> phases_for(Effect effect);

/// How an effect's cost was found.
enum class CostBasis {
    switched,    ///< timed against the same scene with this effect the other way
    phases,      ///< the scene cannot do without it: the phases of the step that run for it, and all that runs in them
    shared,      ///< required too, but it has no phase of its own to time
    impossible,  ///< it has nothing to act on
    failed       ///< could be switched, but was not measured: `note` says why
};

struct EffectCost {
    EffectChoice choice;
    CostBasis basis = CostBasis::impossible;
    double share = 0;                   ///< part of the scene's CPU time that it takes while on
    double change = 0;                  ///< switched: of the CPU time per simulated second, relative
    std::optional<double> uncertainty;  ///< of `change`, 95 %; none = too few comparisons to tell
    double rate_change = 0;             ///< switched: of the particle-steps per CPU second [1/s]
    double step_ratio = 1;              ///< switched: how many times as long a time step becomes
    std::size_t rounds = 0;             ///< comparisons made
    std::string note;                   ///< failed: why
    std::vector<FieldBytes> memory;
};

struct SceneCost {
    std::uint64_t steps = 0;                               ///< of the scene alone, timed on one thread
    double cpu_per_step = 0;                               ///< [s]
    double cpu_per_second = 0;                             ///< CPU time per simulated second
    double rate = 0;                                       ///< particle-steps per CPU second [1/s]
    std::array<double, step_phase_names.size()> phases{};  ///< shares of their time in a step
    int threads = 1;
    double wall_per_second = 0;       ///< wall time per simulated second with so many threads
    double seconds = 0;               ///< wall time that all this took
    double load = 0;                  ///< programs that the machine ran or kept waiting, in the minute before
    std::vector<EffectCost> effects;  ///< in the order of the table, each of it
};

/// What some steps have cost, or all so far.
struct CostTurn {
    double cpu = 0, wall = 0, simulated = 0;  ///< [s]
    double steps = 0, particle_steps = 0;

    CostTurn& operator+=(const CostTurn& t) {
        cpu += t.cpu, wall += t.wall, simulated += t.simulated, steps += t.steps, particle_steps += t.particle_steps;
        return *this;
    }
};

/// What turns of a scene say against as many of it with the effect the other way, `rate` being the scene's alone [1/s]:
/// all of EffectCost that `switched` has.
void judge_turns(std::span<const CostTurn> plain, std::span<const CostTurn> switched, double rate, EffectCost& effect);

/// How long the measuring may take.
struct CostEffort {
    double seconds = 1;  ///< CPU time to be about used; exceeded by scenes whose steps are long
    double limit = 60;   ///< wall time after which no further effect is measured [s]
};

/// The cost of each effect is measured, not guessed: two copies of the scene, in one of which the effect is switched,
/// are advanced in turns, a few steps at a time, on one thread and by the process's CPU time. The ratio of the CPU time
/// per simulated second is taken for each pair of turns, as effects may change the time step; the median of the ratios
/// counts. Both copies start as the scene does, so what an effect costs later is not seen.
///
/// Throws SceneError, NumericalError as a run does.
template <int Dim>
SceneCost measure_cost(const Scene& scene, const CostEffort& effort = {});

}  // namespace sluice
