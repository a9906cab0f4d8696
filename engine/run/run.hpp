// A run from start to end: steps, output, and what happens when it is stopped or fails.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/run/run_record.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

struct RunOptions {
    std::filesystem::path directory;      ///< for the results; made if need be
    int threads = 0;                      ///< 0 = as many as OpenMP offers
    std::optional<double> until;          ///< simulated time to run to [s], in place of the scene's
    std::filesystem::path resume_from{};  ///< a checkpoint in the directory to go on from; empty = start anew
    std::FILE* progress = stderr;         ///< where to tell how it goes; null = nowhere
    std::optional<int> traced_steps{};    ///< profile the run, and trace so many of its steps
};

struct RunStatus {
    RunState state = RunState::done;
    std::string message;  ///< why it failed
    std::string report;   ///< the table that ends a run
};

/// Runs a scene and writes scene.toml, frames/, probes.csv and summary.json into the directory, profile.json and
/// trace.json if it is profiled. A numerical failure is a status; whatever was written before it stays readable. Throws
/// SceneError before anything is written, OutputError.
///
/// Resumed from a checkpoint, results are those of a run that was never stopped: what was written after the checkpoint
/// is cut back. Throws CheckpointError, before anything is cut, if the checkpoint is not of this scene.
RunStatus run(const Scene& scene, const RunOptions& options);

}  // namespace sluice
