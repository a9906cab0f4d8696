// Runs of a study that are done, kept so that none is made twice.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/study/child_run.hpp"

namespace sluice {

/// How a finished run ended and what it cost.
struct RunResult {
    bool failed = false;
    std::string reason;  ///< in one line
    double cpu = 0, wall = 0;
    std::string build;  ///< of the program that made it
};

/// What a run in `folder` came to; none if it has to be made again: interrupted, killed, or its disk full.
std::optional<RunResult> result_of_end(const ChildEnd& end, const std::filesystem::path& folder);

/// FOLDER/result.json. None if there is none or it cannot be understood.
std::optional<RunResult> load_result(const std::filesystem::path& folder);
/// Throws OutputError.
void store_result(const std::filesystem::path& folder, const RunResult& result);

/// Why a run that left these files ended with an error; one line.
std::string failure_reason(const ChildEnd& end, const std::filesystem::path& folder);

/// Tells builds of the program apart, whatever version they call themselves.
std::string build_of(const std::filesystem::path& program);

/// What a run's streams went into.
inline constexpr const char* log_name = "log.txt";

}  // namespace sluice
