#include "engine/output/run_record.hpp"

#include <sys/resource.h>

namespace sluice {
namespace {

rusage usage() {
    rusage u{};
    ::getrusage(RUSAGE_SELF, &u);
    return u;
}

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

}  // namespace

std::string_view name_of(RunState state) {
    switch (state) {
        case RunState::running:
            return "running";
        case RunState::done:
            return "done";
        case RunState::interrupted:
            return "interrupted";
        case RunState::failed:
            return "failed";
    }
    return "unknown";
}

double process_cpu_seconds() {
    const rusage u = usage();
    return seconds(u.ru_utime) + seconds(u.ru_stime);
}

std::size_t peak_memory_bytes() {
    return static_cast<std::size_t>(usage().ru_maxrss) * 1024;  // Linux counts in KiB
}

std::vector<double> seconds_per_phase(const PhaseTimer& timer, const RunRecord& record) {
    std::vector<double> seconds(timer.seconds().begin(), timer.seconds().end());
    seconds[static_cast<std::size_t>(StepPhase::output)] += record.output_seconds + record.checkpoint_seconds;
    return seconds;
}

}  // namespace sluice
