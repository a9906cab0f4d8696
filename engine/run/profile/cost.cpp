#include "engine/run/profile/cost.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <new>
#include <numeric>
#include <utility>

#include "engine/base/errors.hpp"
#include "engine/base/process_usage.hpp"
#include "engine/run/watch/state_check.hpp"
#include "engine/simulation/simulation.hpp"
#include "neighbor/thread_count.hpp"

namespace sluice {
namespace {

using Verdict = Decision::Verdict;
using Clock = std::chrono::steady_clock;
using Shares = decltype(SceneCost::phases);
using Turn = CostTurn;

constexpr std::pair<Effect, StepPhase> required_phases[]{
    {Effect::fluid_pressure, StepPhase::fluid_pass},      {Effect::fluid_pressure, StepPhase::density_pass},
    {Effect::solid_stress, StepPhase::solid_pass},        {Effect::solid_stress, StepPhase::gradient_pass},
    {Effect::total_lagrangian, StepPhase::solid_pass},    {Effect::total_lagrangian, StepPhase::gradient_pass},
    {Effect::interface_force, StepPhase::interface_pass}, {Effect::moving_boundary, StepPhase::interface_pass},
    {Effect::fixed_wall, StepPhase::wall_pass},
};

/// Turns and warm-up are multiples of this many steps, so that what is not done in every step is in each of them: of
/// that, particle shifting is the most seldom (engine/step/parts/particle_shifting.cpp).
constexpr int step_cycle = 4;
/// Turns into which the time for one comparison is cut: enough for a median that one or two interrupted turns leave
/// alone, and long enough for the clock (1 µs).
constexpr int turns = 9;
/// The fewest of which a median leaves an outlier out.
constexpr std::size_t fewest_turns = 3;

/// What has been spent since a start.
struct Stopwatch {
    Clock::time_point start = Clock::now();
    double cpu_start = process_cpu_seconds();

    double wall() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
    double cpu() const { return process_cpu_seconds() - cpu_start; }
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// Student's t for 95 % and n values [Abramowitz & Stegun, eq. 26.7.5, at the normal distribution's 1.96]; 3 % too
/// small for three values, exact from five on.
double student_t(std::size_t n) {
    const double r = 1 / static_cast<double>(n - 1);
    return 1.96 + r * (2.372 + r * (2.823 + r * 2.556));
}

/// t √(π/2) σ/√n, the 95 % interval of a median of normally distributed values, with σ = 1.4826 times the median
/// distance from the median, which interrupted turns do not move [Huber & Ronchetti, Robust Statistics, 2nd ed., ch.
/// 5].
std::optional<double> uncertainty_of_median(const std::vector<double>& values, double middle) {
    if (values.size() < fewest_turns) return std::nullopt;
    std::vector<double> distances;
    for (const double v : values) distances.push_back(std::abs(v - middle));
    const double sigma = 1.4826 * median(distances);
    return student_t(values.size()) * std::sqrt(M_PI / 2 / static_cast<double>(values.size())) * sigma;
}

template <int Dim>
Turn advance(Simulation<Dim>& simulation, int steps) {
    const WorkCount before = simulation.work();
    const double time = simulation.time();
    const Stopwatch watch;
    for (int s = 0; s < steps; ++s) simulation.step();
    const double cpu = watch.cpu(), wall = watch.wall();
    const std::uint64_t particle_steps = simulation.work().particle_steps - before.particle_steps;
    return {cpu, wall, simulation.time() - time, static_cast<double>(steps), static_cast<double>(particle_steps)};
}

/// The steps of a turn of about so many seconds.
int steps_for(double seconds, const Turn& example) {
    const double step = std::max(example.cpu, 1e-9) / example.steps;  // never 0, however coarse the clock
    const double cycles = seconds / (step_cycle * step);
    return step_cycle * static_cast<int>(std::clamp(std::round(cycles), 1.0, 1e4));
}

/// Turns until the time is used: at least three, unless three would exceed the limit; at least one.
template <class TakeTurn>
void take_turns(const Stopwatch& watch, const CostEffort& effort, TakeTurn&& take_turn) {
    for (std::size_t n = 1;; ++n) {
        take_turn(n);
        const double with_another = watch.wall() * (1 + 1 / static_cast<double>(n));
        if ((n >= fewest_turns && watch.cpu() > effort.seconds) || with_another > effort.limit) return;
    }
}

/// Time in the phases of those steps that no other program has interrupted: they are timed by the wall clock.
class PhaseSums {
  public:
    /// Takes a step.
    template <int Dim>
    Turn add(Simulation<Dim>& simulation) {
        const Shares before = simulation.timer().seconds();
        const Turn step = advance(simulation, 1);
        const bool interrupted = step.wall > 1.1 * step.cpu + 1e-5;  // 10 µs: the clocks' own time
        for (std::size_t k = 0; k < all_.size(); ++k) {
            const double seconds = simulation.timer().seconds()[k] - before[k];
            all_[k] += seconds;
            if (!interrupted) calm_[k] += seconds;
        }
        if (!interrupted) ++calm_steps_;
        return step;
    }

    /// Of all phases together. Every step counts if hardly one was left alone, or the CPU clock is too coarse to tell.
    Shares shares() const {
        Shares shares = calm_steps_ >= step_cycle ? calm_ : all_;
        const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
        for (double& share : shares) share /= sum;
        return shares;
    }

  private:
    Shares all_{}, calm_{};
    int calm_steps_ = 0;
};

/// On one thread: time per step and second, and phases. Returns the CPU time per simulated second of the fastest turn.
template <int Dim>
double time_one_thread(Simulation<Dim>& simulation, const CostEffort& effort, int steps, SceneCost& cost) {
    const Stopwatch watch;
    const ThreadCount one(1);
    PhaseSums phases;
    std::vector<double> per_second, per_step, rate;
    take_turns(watch, effort, [&](std::size_t) {
        Turn turn;
        for (int s = 0; s < steps; ++s) turn += phases.add(simulation);
        per_second.push_back(turn.cpu / turn.simulated);
        per_step.push_back(turn.cpu / turn.steps);
        rate.push_back(turn.particle_steps / turn.cpu);
        cost.steps += static_cast<std::uint64_t>(steps);
    });
    cost.cpu_per_second = median(per_second), cost.cpu_per_step = median(per_step), cost.rate = median(rate);
    cost.phases = phases.shares();
    return *std::min_element(per_second.begin(), per_second.end());
}

/// The scene alone. What threads gain is taken from the fastest turns, as other programs only make them slower.
template <int Dim>
void time_scene(const Scene& scene, const CostEffort& effort, SceneCost& cost) {
    Simulation<Dim> simulation(scene);
    const CostEffort half{effort.seconds / 2, effort.limit / 2};
    int steps = step_cycle;
    {
        const ThreadCount one(1);
        steps = steps_for(half.seconds / turns, advance(simulation, step_cycle));
    }
    const double fastest = time_one_thread(simulation, half, steps, cost);
    cost.threads = omp_get_max_threads();
    cost.wall_per_second = cost.cpu_per_second;
    if (cost.threads > 1) {
        advance(simulation, step_cycle);
        double fastest_together = HUGE_VAL;
        take_turns(Stopwatch{}, half, [&](std::size_t) {
            const Turn turn = advance(simulation, steps);
            fastest_together = std::min(fastest_together, turn.wall / turn.simulated);
        });
        cost.wall_per_second *= fastest_together / fastest;
    }
    check_state(simulation);
}

/// The scene against the scene with one effect the other way.
template <int Dim>
void compare(const Scene& scene, const CostEffort& effort, double rate, EffectCost& effect) {
    const Stopwatch watch;
    Scene switched_scene = scene;
    switched_scene.switches[effect.choice.info.effect] = effect.choice.on ? Switch::off : Switch::on;
    Simulation<Dim> plain(scene), switched(switched_scene);
    const ThreadCount one(1);
    Turn slower = advance(plain, step_cycle);
    const Turn other = advance(switched, step_cycle);
    if (other.cpu > slower.cpu) slower = other;
    const int steps = steps_for(effort.seconds / (2 * turns), slower);
    std::vector<Turn> plain_turns, switched_turns;
    take_turns(watch, effort, [&](std::size_t n) {
        // In turns, so that neither always finds the caches as the other has left them.
        if (n % 2 == 0) switched_turns.push_back(advance(switched, steps));
        plain_turns.push_back(advance(plain, steps));
        if (n % 2 == 1) switched_turns.push_back(advance(switched, steps));
    });
    check_state(switched);
    judge_turns(plain_turns, switched_turns, rate, effect);
}

/// Whatever may go wrong with the effect the other way is no failure of the scene.
template <int Dim>
void try_to_compare(const Scene& scene, const CostEffort& effort, double rate, EffectCost& effect) {
    effect.basis = CostBasis::failed;
    try {
        compare<Dim>(scene, effort, rate, effect);
    } catch (const SceneError& error) {
        effect.note = error.what();
    } catch (const NumericalError& error) {
        effect.note = error.what();
    } catch (const std::bad_alloc&) {
        effect.note = "no memory for two copies of the scene";
    }
}

bool can_be_switched(const EffectChoice& choice) {
    switch (choice.decision.verdict) {
        case Verdict::used:
        case Verdict::unused:
            return true;
        case Verdict::impossible:
        case Verdict::required:
            break;
    }
    return false;
}

/// What is known of an effect before it is switched.
template <int Dim>
EffectCost without_switching(const EffectChoice& choice, const SceneCost& cost) {
    EffectCost effect;
    effect.choice = choice;
    effect.memory = field_bytes<Dim>(choice.info);
    if (choice.decision.is_impossible()) return effect;
    const std::vector<StepPhase> phases = phases_for(choice.info.effect);
    effect.basis = phases.empty() ? CostBasis::shared : CostBasis::phases;
    for (const StepPhase phase : phases) effect.share += cost.phases[static_cast<std::size_t>(phase)];
    return effect;
}

}  // namespace

std::vector<StepPhase> phases_for(Effect effect) {
    std::vector<StepPhase> phases;
    for (const auto& [of, phase] : required_phases)
        if (of == effect) phases.push_back(phase);
    return phases;
}

void judge_turns(std::span<const Turn> plain, std::span<const Turn> switched, double rate, EffectCost& effect) {
    std::vector<double> ratios;
    for (std::size_t n = 0; n < plain.size(); ++n)
        ratios.push_back(switched[n].cpu / switched[n].simulated / (plain[n].cpu / plain[n].simulated));
    const Turn &a = plain.back(), &b = switched.back();
    const double ratio = median(ratios);
    effect.basis = CostBasis::switched;
    effect.rounds = ratios.size();
    effect.change = ratio - 1;
    effect.uncertainty = uncertainty_of_median(ratios, ratio);
    effect.share = effect.choice.on ? -effect.change : 0;
    effect.step_ratio = (b.simulated / b.steps) / (a.simulated / a.steps);
    effect.rate_change = rate * ((b.particle_steps / b.simulated) / (a.particle_steps / a.simulated) / ratio - 1);
}

template <int Dim>
SceneCost measure_cost(const Scene& scene, const CostEffort& effort) {
    const Stopwatch watch;
    const Effects effects(scene);
    // The scene alone is measured like one effect more.
    const auto parts =
        1 + static_cast<double>(std::count_if(effects.all().begin(), effects.all().end(), can_be_switched));
    const CostEffort part{effort.seconds / parts, effort.limit / parts};
    SceneCost cost;
    if (::getloadavg(&cost.load, 1) != 1) cost.load = 0;  // not known
    time_scene<Dim>(scene, part, cost);
    for (const EffectChoice& choice : effects.all()) {
        EffectCost effect = without_switching<Dim>(choice, cost);
        if (can_be_switched(choice)) {
            if (watch.wall() < effort.limit) {
                try_to_compare<Dim>(scene, part, cost.rate, effect);
            } else {
                effect.basis = CostBasis::failed;
                effect.note = "the time for measuring was used up";
            }
        }
        cost.effects.push_back(std::move(effect));
    }
    cost.seconds = watch.wall();
    return cost;
}

template SceneCost measure_cost<2>(const Scene&, const CostEffort&);
template SceneCost measure_cost<3>(const Scene&, const CostEffort&);

}  // namespace sluice
