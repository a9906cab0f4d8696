#include "engine/profile/scene_bench.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation.hpp"
#include "engine/thread_count.hpp"
#include "engine/watch/state_check.hpp"

namespace sluice {
namespace {

/// Turns of one and of all threads: enough for both to meet whatever else the machine does.
constexpr int turns = 6;
/// Particle shifting, the most seldom of what is done every few steps, is done every fourth at the most.
constexpr int step_cycle = 4;

double seconds_since(Nanoseconds start) { return 1e-9 * static_cast<double>(clock_now() - start); }

/// Steps for about so many seconds on so many threads.
template <int Dim>
void take_turn(Simulation<Dim>& simulation, StepProfile& profile, double seconds, double& particle_steps) {
    const ThreadCount count(profile.threads());
    simulation.step();  // brings the data to the cores that will use them
    const std::uint64_t before = simulation.work().particle_steps;
    const Nanoseconds start = clock_now();
    do
        for (int s = 0; s < step_cycle; ++s) {
            const StepProfile::Step step(&profile, simulation.work().steps, simulation.time());
            simulation.step();
        }
    while (seconds_since(start) < seconds);
    particle_steps += static_cast<double>(simulation.work().particle_steps - before);
}

const ProfileRow* find_row(const Profile& profile, const ProfileRow& like) {
    for (const ProfileRow& row : profile.rows)
        if (row.kind == like.kind && row.name == like.name && row.phase == like.phase) return &row;
    return nullptr;
}

}  // namespace

template <int Dim>
SceneBench bench_scene(const Scene& scene, double seconds) {
    const Nanoseconds start = clock_now();
    const int threads = omp_get_max_threads();
    Simulation<Dim> simulation(scene);
    SceneBench bench{measure_machine(threads), {}, {}, 0, 0, 0, 0, 0};
    for (int s = 0; s < step_cycle; ++s) simulation.step();
    StepProfile one(1), all(threads);
    for (int n = 0; n < turns; ++n) {
        const double left = (seconds - seconds_since(start)) / (turns - n);
        if (n > 0 && left < 0) break;
        take_turn(simulation, one, threads > 1 ? left / 2 : left, bench.one.particle_steps);
        if (threads > 1) take_turn(simulation, all, left / 2, bench.all.particle_steps);
    }
    check_state(simulation);
    bench.one.profile = profile_of(one, simulation.effects());
    if (threads > 1)
        bench.all.profile = profile_of(all, simulation.effects());
    else
        bench.all = bench.one;
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
    // Below this a loop does neither long enough to be bound by it: what it waits for, or how it begins, counts more.
    constexpr double bound = 0.2, idle = 0.3;
    const Roof roof = roof_of(row, bench, bench.all.profile.threads);
    const bool computes = roof.arithmetic >= roof.bandwidth;
    const MemoryLevel& level = bench.machine.level_of(bench.field_bytes, bench.all.profile.threads);
    const std::string share = fmt::format("{:.0f} % of {}", 100 * roof.of_roof(),
                                          computes ? "the arithmetic peak" : std::string(level.name) + " bandwidth");
    if (row.waiting() > idle) return fmt::format("{}, threads wait {:.0f} % of it", share, 100 * row.waiting());
    if (roof.of_roof() < bound) return share + ", bound by neither: latency, short loops";
    return share + (computes ? ", compute-bound" : ", memory-bound");
}

template SceneBench bench_scene<2>(const Scene&, double);
template SceneBench bench_scene<3>(const Scene&, double);

}  // namespace sluice
