#include "engine/run/profile/scene_bench.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/base/wall_clock.hpp"
#include "engine/run/watch/state_check.hpp"
#include "engine/simulation/simulation.hpp"
#include "neighbor/thread_count.hpp"

namespace sluice {
namespace {

/// Turns of one and of all threads: enough for both to meet whatever else the machine does.
constexpr int bench_turns = 6;
/// Particle shifting, the most seldom of what is done every few steps, is done every fourth at the most.
constexpr int bench_cycle = 4;
/// Enough to tell something by; where other programs interrupt all but a few steps, those that they do interrupt count.
constexpr std::uint64_t fewest_steps = 20;

/// Steps on one number of threads.
template <int Dim>
struct Timing {
    StepProfile profile;
    double particle_steps = 0;
    std::uint64_t interrupted = 0;

    /// Steps for about so many seconds. One that another program interrupted tells nothing of the scene: it is left
    /// out, unless all must count.
    void take_turn(Simulation<Dim>& simulation, double seconds, bool all_count) {
        const ThreadCount count(profile.threads());
        simulation.step();  // brings the data to the cores that will use them
        const auto start = WallClock::now();
        do {
            for (int s = 0; s < bench_cycle; ++s) {
                const StepProfile kept = profile;
                const std::uint64_t before = simulation.work().particle_steps;
                const long interruptions_before = interruptions();
                {
                    const StepProfile::Step step(&profile, simulation.work().steps, simulation.time());
                    simulation.step();
                }
                const bool calm = interruptions() == interruptions_before;
                if (!calm) ++interrupted;
                if (calm || all_count)
                    particle_steps += static_cast<double>(simulation.work().particle_steps - before);
                else
                    profile = kept;
            }
            check_state(simulation);  // between steps, where no time is taken
        } while (seconds_since(start) < seconds);
    }

    ThreadBench result(const Effects& effects) const {
        return {profile_of(profile, effects), particle_steps, interrupted};
    }
};

}  // namespace

template <int Dim>
SceneBench bench_scene(const Scene& scene, double seconds) {
    const auto start = WallClock::now();
    const int threads = omp_get_max_threads();
    Simulation<Dim> simulation(scene);
    SceneBench bench;
    if (::getloadavg(&bench.load, 1) != 1) bench.load = 0;  // not known
    bench.machine = measure_machine(threads);
    for (int s = 0; s < bench_cycle; ++s) simulation.step();
    Timing<Dim> one{StepProfile(1)}, all{StepProfile(threads)};
    for (int n = 0; n < bench_turns; ++n) {
        const double left = (seconds - seconds_since(start)) / (bench_turns - n);
        const bool last = n + 1 == bench_turns || left < 0;
        one.take_turn(simulation, threads > 1 ? left / 2 : left, last && one.profile.steps() < fewest_steps);
        if (threads > 1) all.take_turn(simulation, left / 2, last && all.profile.steps() < fewest_steps);
        if (last) break;
    }
    bench.one = one.result(simulation.effects());
    bench.all = threads > 1 ? all.result(simulation.effects()) : bench.one;
    bench.field_bytes = static_cast<double>(simulation.memory_bytes());
    bench.fluid = static_cast<double>(simulation.fluid().owned);
    bench.solid = static_cast<double>(simulation.solid().owned);
    bench.wall = static_cast<double>(simulation.wall().owned);
    bench.simulated = simulation.time();
    return bench;
}

Roof roof_of(const ProfileRow& row, const SceneBench& bench, int threads) {
    const auto of = [&](const Limit& limit) { return threads == 1 ? limit.one_thread : limit.all_threads; };
    const MemoryLevel& level = bench.machine.level_of(bench.field_bytes, threads);
    if (row.bytes() == 0 || row.seconds == 0) return {};
    return {row.operations / row.bytes(),
            row.operations / row.seconds / of(bench.machine.arithmetic(static_cast<std::size_t>(row.number_bytes))),
            row.bytes() / row.seconds / of(level.bandwidth)};
}

double efficiency(const ProfileRow& row, const SceneBench& bench) {
    const ProfileRow *one = find_row(bench.one.profile, row), *all = find_row(bench.all.profile, row);
    if (!one || !all || all->seconds == 0) return 0;
    const double per_step_one = one->seconds / static_cast<double>(bench.one.profile.steps);
    const double per_step_all = all->seconds / static_cast<double>(bench.all.profile.steps);
    return per_step_one / per_step_all / bench.all.profile.threads;
}

std::string verdict(const ProfileRow& row, const SceneBench& bench) {
    // Below this a loop does neither long enough to be bound by it: how it begins and ends counts more.
    constexpr double bound = 0.2, idle = 0.3;
    const int threads = bench.all.profile.threads;
    const ProfileRow* of_one = find_row(bench.one.profile, row);
    const Roof roof = of_one ? roof_of(*of_one, bench, 1) : roof_of(row, bench, threads);
    const bool computes = roof.arithmetic >= roof.bandwidth;
    const MemoryLevel& level = bench.machine.level_of(bench.field_bytes, of_one ? 1 : threads);
    const std::string limit = computes ? "arithmetic peak" : std::string(level.name) + " bandwidth";
    std::string text = fmt::format("{:.0f} % of the {}, ", 100 * roof.of_roof(), limit);
    text += roof.of_roof() < bound ? "bound by neither: short or irregular"
            : computes             ? "compute-bound"
                                   : "memory-bound";
    if (!of_one || threads == 1) return text;
    const Roof together = roof_of(row, bench, threads);
    text +=
        fmt::format("; on {} threads {:.0f} %", threads, 100 * (computes ? together.arithmetic : together.bandwidth));
    if (row.waiting() > idle) text += fmt::format(", they wait {:.0f} % of it", 100 * row.waiting());
    return text;
}

template SceneBench bench_scene<2>(const Scene&, double);
template SceneBench bench_scene<3>(const Scene&, double);

}  // namespace sluice
