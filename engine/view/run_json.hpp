// The JSON files of a run, read back. (One file of its own: compiling the parser takes longer than all that asks it.)
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/view/frame_file.hpp"

namespace sluice {

/// The frames that a series file names. Throws RunReadError.
std::vector<FrameFile> read_series(const std::filesystem::path& series);

/// Of summary.json; what it lacks is left as it is here.
struct SummaryFacts {
    std::string status, title;
    std::optional<double> end_time;  ///< [s]
};
/// Nothing of a summary that is not there, or cannot be read.
SummaryFacts read_summary(const std::filesystem::path& directory);

}  // namespace sluice
