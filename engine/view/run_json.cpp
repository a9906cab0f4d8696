#include "engine/view/run_json.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/base/errors.hpp"

namespace sluice {

std::vector<FrameFile> read_series(const std::filesystem::path& series) {
    std::ifstream stream(series);
    std::vector<FrameFile> frames;
    try {
        const nlohmann::json list = nlohmann::json::parse(stream);
        for (const auto& file : list.at("files"))
            frames.push_back(
                {series.parent_path() / file.at("name").get<std::string>(), file.at("time").get<double>()});
    } catch (const nlohmann::json::exception&) {
        throw RunReadError(fmt::format("{}: is no list of frames as a run writes it", series.string()));
    }
    return frames;
}

SummaryFacts read_summary(const std::filesystem::path& directory) {
    std::ifstream stream(directory / "summary.json");
    const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
    SummaryFacts facts;
    if (!json.is_object()) return facts;
    const auto text = [&json](const char* key) {
        const auto found = json.find(key);
        return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    facts.status = text("status");
    facts.title = text("title");
    const auto end = json.find("end_time");
    if (end != json.end() && end->is_number()) facts.end_time = end->get<double>();
    return facts;
}

}  // namespace sluice
