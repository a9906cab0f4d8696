// How a run is going, apart from its physics: state, time spent, threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/run/watch/warning.hpp"
#include "engine/step/energy_balance.hpp"
#include "engine/step/phase_timer.hpp"

namespace sluice {

enum class RunState { running, done, interrupted, failed };
/// As summary.json has it.
std::string_view name_of(RunState state);

struct RunRecord {
    RunState state = RunState::running;
    std::string message;  ///< why it failed
    double end_time = 0;  ///< simulated time to run to [s]
    int threads = 1;
    double wall_seconds = 0;                ///< since the start, placing of particles and output included
    double cpu_seconds = 0;                 ///< likewise, all threads
    double setup_seconds = 0;               ///< wall time of placing particles and opening files
    double step_seconds = 0;                ///< wall time in time steps alone; rates refer to it
    double output_seconds = 0;              ///< wall time in frames, probes and summaries
    double checkpoint_seconds = 0;          ///< wall time in writing checkpoints; not part of the output's
    double disk_wait_seconds = 0;           ///< of both, waiting for the disk
    std::uint64_t checkpoints = 0;          ///< written
    std::vector<std::uint64_t> resumed_at;  ///< steps after which the run was gone on with
    std::uint64_t looks = 0;                ///< at the state, by the watch
    std::uint64_t snapshots = 0;            ///< states kept in memory to go back to
    double watch_seconds = 0;               ///< wall time in looks at the state and in snapshots
    std::vector<Retry> retries;             ///< since the program was started
    std::uint64_t retry_count = 0;          ///< of the whole run
    std::vector<Warning> warnings;          ///< what looked wrong
    EnergyBalance initial_energy;
    std::vector<std::string> probe_columns;
    std::vector<double> probe_values;  ///< latest

    /// visit(name, member) for what a run that goes on adds up further.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("wall_seconds", wall_seconds), visit("cpu_seconds", cpu_seconds), visit("setup_seconds", setup_seconds);
        visit("step_seconds", step_seconds), visit("output_seconds", output_seconds);
        visit("checkpoint_seconds", checkpoint_seconds), visit("checkpoints", checkpoints);
        visit("resumed_at", resumed_at), visit("retry_count", retry_count);
        visit("disk_wait_seconds", disk_wait_seconds);
    }

    /// `count` per second of stepping; 0 before the first step.
    double rate(double count) const { return step_seconds > 0 ? count / step_seconds : 0.0; }
};

/// Seconds in each phase of a step, and in output, named by step_phase_names: what summary and report show.
std::vector<double> seconds_per_phase(const PhaseTimer& timer, const RunRecord& record);

}  // namespace sluice
