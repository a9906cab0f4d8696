// What a study will run, settled before the first run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/study/study.hpp"

namespace sluice {

struct StudyOptions {
    std::string scene;                  ///< file
    std::vector<std::string> settings;  ///< key=value, for all runs
    std::vector<std::string> vary;      ///< key=V1,V2,…
    int repeats = 1;
    int threads = 1;                  ///< of each run
    std::filesystem::path directory;  ///< for the results
    bool again = false;               ///< make finished runs anew
};

/// How one point of the matrix is run.
struct PlannedRun {
    std::vector<std::string> overrides;
    std::string key;      ///< of scene, overrides, threads and version: names its folder
    std::string refusal;  ///< what is wrong with the scene so changed; empty = nothing
};

struct Plan {
    Scene scene;  ///< with the settings of all runs
    Study study;
    std::vector<PlannedRun> runs;  ///< one per point of the study
};

/// Throws SceneError if the scene, a key, or every combination is wrong; a combination that is refused while others are
/// not is a point that failed.
Plan make_plan(const StudyOptions& options);

/// Coarse to fine, so that the first runs tell how long the rest will take; equal ones as the matrix has them.
std::vector<std::size_t> run_order(const Study& study);

}  // namespace sluice
