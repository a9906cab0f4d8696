#include "engine/study/study_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "engine/scene/scene.hpp"

namespace sluice {
namespace {

using Json = nlohmann::ordered_json;

Json optional(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::optional<double> optional(const Json& json) {
    return json.is_number() ? std::optional<double>(json.get<double>()) : std::nullopt;
}

Json to_json(const Quantity& q) {
    return {{"name", q.name},
            {"meaning", q.meaning},
            {"scale", q.scale},
            {"unit", q.unit},
            {"uncertainty", optional(q.uncertainty)},
            {"extrapolated", q.extrapolated},
            {"note", q.note}};
}

Quantity quantity_from(const Json& json) {
    Quantity q;
    q.name = json.at("name");
    q.meaning = json.at("meaning");
    q.scale = json.at("scale");
    q.unit = json.at("unit");
    q.uncertainty = optional(json.at("uncertainty"));
    q.extrapolated = json.at("extrapolated");
    q.note = json.at("note");
    return q;
}

Json to_json(const StudyPoint& p, const Study& study) {
    Json json{{"values", p.values}, {"method", p.method}, {"spacing", p.spacing}, {"state", word_of(p.state)}};
    if (!p.reason.empty()) json["reason"] = p.reason;
    json["cpu_seconds"] = p.cpu;
    json["wall_seconds"] = p.wall;
    json["error"] = Json::object();
    for (std::size_t q = 0; q < p.error.size(); ++q) json["error"][study.quantities[q].name] = optional(p.error[q]);
    return json;
}

StudyPoint point_from(const Json& json, const Study& study) {
    StudyPoint p;
    p.values = json.at("values").get<std::vector<std::string>>();
    p.method = json.at("method");
    if (p.method >= study.methods.size() || p.values.size() != study.axes.size())
        throw std::runtime_error("a point of a method that is not there");
    p.spacing = json.at("spacing");
    p.state = value_of_word<PointState>(json.at("state").get<std::string>()).value_or(PointState::missing);
    p.reason = json.value("reason", "");
    p.cpu = json.at("cpu_seconds").get<std::vector<double>>();
    p.wall = json.at("wall_seconds").get<std::vector<double>>();
    for (const Quantity& q : study.quantities) {
        const Json& errors = json.at("error");
        p.error.push_back(errors.contains(q.name) ? optional(errors.at(q.name)) : std::nullopt);
    }
    return p;
}

/// As spreadsheets quote it.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

Study parse_study(const Json& json) {
    Study study;
    study.title = json.at("title");
    study.scene = json.at("scene");
    study.fingerprint = json.at("fingerprint");
    study.version = json.at("version");
    study.date = json.at("date");
    const Json& machine = json.at("machine");
    study.machine = {machine.at("processor"), machine.at("processors"), machine.at("instruction_set"),
                     machine.at("load_average")};
    study.dimension = json.at("dimension");
    study.threads = json.at("threads");
    study.repeats = json.at("repeats");
    for (const auto& [key, values] : json.at("vary").items())
        study.axes.push_back({key, values.get<std::vector<std::string>>()});
    study.settings = json.at("set").get<std::vector<std::string>>();
    study.methods = json.at("methods").get<std::vector<std::string>>();
    for (const Json& q : json.at("quantities")) study.quantities.push_back(quantity_from(q));
    for (const Json& p : json.at("points")) study.points.push_back(point_from(p, study));
    return study;
}

}  // namespace

std::string json_text(const Study& study) {
    Json json{{"program", "sluice"},
              {"version", study.version},
              {"title", study.title},
              {"scene", study.scene},
              {"fingerprint", study.fingerprint},
              {"date", study.date},
              {"machine",
               {{"processor", study.machine.processor},
                {"processors", study.machine.processors},
                {"instruction_set", study.machine.instruction_set},
                {"load_average", study.machine.load}}},
              {"dimension", study.dimension},
              {"threads", study.threads},
              {"repeats", study.repeats}};
    json["vary"] = Json::object();
    for (const Axis& axis : study.axes) json["vary"][axis.key] = axis.values;
    json["set"] = study.settings;
    json["methods"] = study.methods;
    json["quantities"] = Json::array();
    for (const Quantity& q : study.quantities) json["quantities"].push_back(to_json(q));
    json["points"] = Json::array();
    for (const StudyPoint& p : study.points) json["points"].push_back(to_json(p, study));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Study study_from_json(const std::string& text) {
    try {
        return parse_study(Json::parse(text));
    } catch (const Json::exception& error) {
        throw std::runtime_error(error.what());
    }
}

Study load_study(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw SceneError(fmt::format("{}: cannot be read, expected a study.json", file.string()));
    std::ostringstream text;
    text << stream.rdbuf();
    try {
        return study_from_json(text.str());
    } catch (const std::runtime_error& error) {
        throw SceneError(
            fmt::format("{}: found no study: {}, expected what `sluice study` writes", file.string(), error.what()));
    }
}

std::string csv_text(const Study& study) {
    std::string text;
    for (const Axis& axis : study.axes) text += cell(axis.key) + ",";
    text += "method,spacing [m],state,runs,CPU time [s],wall time [s]";
    for (const Quantity& q : study.quantities) text += fmt::format(",{}", cell("error of " + q.name));
    text += ",reason\n";
    for (const StudyPoint& p : study.points) {
        for (const std::string& value : p.values) text += cell(value) + ",";
        text += fmt::format("{},{},{},{},", cell(study.methods[p.method]), p.spacing, word_of(p.state), p.cpu.size());
        text += p.cpu.empty() ? "," : fmt::format("{},{}", p.cpu_seconds(), p.wall_seconds());
        for (const auto& error : p.error) text += error ? fmt::format(",{}", *error) : ",";
        text += fmt::format(",{}\n", cell(p.reason));
    }
    return text;
}

}  // namespace sluice
