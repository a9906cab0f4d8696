#include "engine/run/run_record.hpp"

namespace sluice {

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

std::vector<double> seconds_per_phase(const PhaseTimer& timer, const RunRecord& record) {
    std::vector<double> seconds(timer.seconds().begin(), timer.seconds().end());
    seconds[static_cast<std::size_t>(StepPhase::output)] += record.output_seconds + record.checkpoint_seconds;
    return seconds;
}

}  // namespace sluice
