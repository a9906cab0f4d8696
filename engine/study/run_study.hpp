// Runs the matrix, each setting as a process of its own, and keeps what is done.
#pragma once

#include "engine/study/plan.hpp"

namespace sluice {

enum class StudyEnd { complete, interrupted };

/// Runs what is not yet done: the whole matrix once, then again for each repeat, always in the same order, so that what
/// slows the machine down for a while slows all alike. study.json and study.csv are written after every run. Throws
/// OutputError, SceneError.
StudyEnd run_study(const StudyOptions& options, Plan& plan);

/// DIRECTORY/study.json, .csv, .svg and .html.
void write_study(const Study& study, const std::filesystem::path& directory);

/// "modern, mixed, spacing 10 mm"
std::string point_name(const Study& study, const StudyPoint& point);

}  // namespace sluice
