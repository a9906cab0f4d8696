// Where a stopped run can go on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/run/checkpoint/checkpoint_label.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

struct ResumePoint {
    std::filesystem::path checkpoint;
    CheckpointLabel label;
    std::vector<std::string> warnings;  ///< newer checkpoints that cannot be used, and why
};

/// The newest checkpoint of a run's folder that is sound. Throws CheckpointError if there is none.
ResumePoint find_resume_point(const std::filesystem::path& directory);

/// What is different in a scene from that of the checkpoint, line by line; empty if nothing is.
std::string scene_changes(const ResumePoint& point, const Scene& scene);

/// The simulated time that a finished run has reached, as its summary.json tells; none if it is not finished. [s]
std::optional<double> finished_at(const std::filesystem::path& directory);

}  // namespace sluice
