// How fast a scene's steps are, against what the machine could do.
#pragma once

#include <string>

#include "engine/run/profile/machine_limits.hpp"
#include "engine/run/profile/profile.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

/// Steps by one number of threads.
struct ThreadBench {
    Profile profile;
    double particle_steps = 0;
    std::uint64_t interrupted = 0;  ///< steps that other programs interrupted

    double steps_per_second() const { return static_cast<double>(profile.steps) / profile.seconds; }
    double updates_per_second() const { return particle_steps / profile.seconds; }
};

struct SceneBench {
    MachineLimits machine;
    ThreadBench one, all;                   ///< the same if there is one thread only
    double field_bytes = 0;                 ///< particles and lists: what a step goes through
    double fluid = 0, solid = 0, wall = 0;  ///< particles
    double simulated = 0;                   ///< reached [s]
    double load = 0;                        ///< programs that the machine ran or kept waiting, in the minute before
};

/// How a loop over pairs stands against the machine.
struct Roof {
    double intensity = 0;   ///< operations per byte
    double arithmetic = 0;  ///< part of the arithmetic peak
    double bandwidth = 0;   ///< part of the bandwidth of where the step's data are
    double of_roof() const { return arithmetic > bandwidth ? arithmetic : bandwidth; }
};

/// `threads`: those of the profile that the row is from.
Roof roof_of(const ProfileRow& row, const SceneBench& bench, int threads);

/// Part of the ideal speed-up that all threads reach: 1 thread's time per step over that of all, over their number.
/// 0 = the row is missing from one of them.
double efficiency(const ProfileRow& row, const SceneBench& bench);

/// "61 % of the arithmetic peak, compute-bound; on 2 threads 57 %": what bounds it is judged on one thread.
std::string verdict(const ProfileRow& row, const SceneBench& bench);

/// Takes steps of the scene on one thread and on all, in turns, for about so many seconds. It starts as the scene does.
/// Throws SceneError, NumericalError as a run does.
template <int Dim>
SceneBench bench_scene(const Scene& scene, double seconds);

/// For people.
std::string bench_text(const SceneBench& bench, const Scene& scene, const Effects& effects);
/// For programs.
std::string bench_json(const SceneBench& bench, const Scene& scene, const Effects& effects);

}  // namespace sluice
