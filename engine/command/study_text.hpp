// Studies and references, for people at a terminal.
#pragma once

#include <filesystem>
#include <string>

#include "engine/scene/scene.hpp"
#include "engine/study/study.hpp"

namespace sluice {

/// A row per run: cost and errors, or why it failed.
std::string study_table(const Study& study);

/// A row per reference of the scene: what it compares, what 100 % is, its uncertainty. Throws SceneError for one that
/// cannot be used.
std::string reference_table(const Scene& scene);

/// Which settings reach an error, by a stored study. Throws SceneError if that is no study of this scene.
std::string target_report(const Scene& scene, const std::filesystem::path& file, double target);

}  // namespace sluice
