// study.json and study.csv.
#pragma once

#include <filesystem>
#include <string>

#include "engine/study/study.hpp"

namespace sluice {

std::string json_text(const Study& study);
/// Throws std::runtime_error for a text that is no study.
Study study_from_json(const std::string& text);
/// Throws SceneError naming the file.
Study load_study(const std::filesystem::path& file);

/// A row per setting: its values, cost, errors as shares, and why it failed.
std::string csv_text(const Study& study);

}  // namespace sluice
