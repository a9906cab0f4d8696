#pragma once

#include <cstdint>
#include <string>

namespace sluice {

/// What a checkpoint says of itself.
struct CheckpointLabel {
    std::string program_version;
    std::string instruction_set;  ///< of the loops over pairs; another one gives other bits
    std::string scene_file;       ///< path, as the run was given it
    std::string scene_source;     ///< Scene::source
    double end_time = 0;          ///< simulated time to run to [s]
    double time = 0;              ///< simulated [s]
    std::uint64_t step = 0;

    /// visit(name, member) for each member.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("program_version", program_version), visit("instruction_set", instruction_set);
        visit("scene_file", scene_file), visit("scene_source", scene_source);
        visit("end_time", end_time), visit("time", time), visit("step", step);
    }
};

}  // namespace sluice
