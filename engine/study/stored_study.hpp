// A study kept beside its scene, and what it says of a run of that scene.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/scene/scene.hpp"
#include "engine/study/study.hpp"

namespace sluice {

/// Where the study of a scene is kept: study.json in the folder of scene.toml, NAME.study.json for NAME.toml.
std::filesystem::path study_beside(const std::string& scene_file);

/// The study's method that a scene runs with; none if the study did not vary to it, or is of another scene.
std::optional<std::size_t> method_of(const Study& study, const Scene& scene);

/// "expected error, by FILE: 1.4 % in velocity; 0.9 % in energy" as the line that ends a run; empty if nothing is
/// stored or it says nothing about such a run.
std::string expectation_text(const Scene& scene);

}  // namespace sluice
