// A whole run with its files, as `sluice run` does it.
#pragma once

#include <optional>
#include <string>

#include "scene.hpp"

namespace sluice::api {

enum class Progress { shown, silent };

struct RunOptions {
    int threads = 0;                       ///< 0 = as many as OpenMP offers
    std::optional<double> until;           ///< simulated time to run to, in place of the scene's [s]
    Progress progress = Progress::silent;  ///< on standard error
};

enum class RunEnd { done, interrupted, failed };

struct RunResult {
    RunEnd end = RunEnd::done;
    std::string message;  ///< why it failed
    std::string report;   ///< the table that ends a run
};

/// Runs a scene and writes scene.toml, frames/, probes.csv, summary.json and checkpoints/ into the folder. The first
/// SIGINT or SIGTERM ends it after a step, with a checkpoint. Throws SceneError, OutputError.
SLUICE_API RunResult run(const Scene& scene, const std::string& directory, const RunOptions& options = {});

/// Goes on with a stopped run, to the same results as if it had not been stopped. Throws CheckpointError, OutputError.
SLUICE_API RunResult resume(const std::string& directory, const RunOptions& options = {});

/// As stated in CMakeLists.txt.
SLUICE_API std::string version();

}  // namespace sluice::api
