#include "engine/run/resume.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/base/errors.hpp"
#include "engine/run/checkpoint/checkpoint_file.hpp"
#include "engine/run/checkpoint/checkpoint_store.hpp"
#include "engine/run/text_difference.hpp"

namespace sluice {

ResumePoint find_resume_point(const std::filesystem::path& directory) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(directory, ignored))
        throw CheckpointError(fmt::format("{}: found no such folder, expected that of a run", directory.string()));
    const std::vector<std::filesystem::path> files = checkpoints_in(directory);
    if (files.empty())
        throw CheckpointError(
            fmt::format("{}: found no checkpoint to go on from; a run writes them as [output] checkpoint_minutes and "
                        "checkpoint_interval say",
                        directory.string()));
    std::vector<std::string> problems;
    for (const std::filesystem::path& file : files) {
        const std::string problem = checkpoint_problem(file);
        if (problem.empty()) return {file, read_label(file), problems};
        problems.push_back(fmt::format("{}: {}", file.string(), problem));
    }
    throw CheckpointError(fmt::format("no checkpoint can be used:\n  {}", fmt::join(problems, "\n  ")));
}

std::string scene_changes(const ResumePoint& point, const Scene& scene) {
    return text_difference(point.label.scene_source, scene.source);
}

std::optional<double> finished_at(const std::filesystem::path& directory) {
    std::ifstream stream(directory / "summary.json");
    const nlohmann::json summary = nlohmann::json::parse(stream, nullptr, false);  // what cannot be read tells nothing
    if (!summary.is_object() || !summary.contains("status") || summary["status"] != "done") return std::nullopt;
    const auto end = summary.find("end_time");
    return end != summary.end() && end->is_number() ? std::optional(end->get<double>()) : std::nullopt;
}

}  // namespace sluice
