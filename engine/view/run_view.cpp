#include "engine/view/run_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/output/version.hpp"
#include "engine/view/color_map.hpp"

namespace sluice {
namespace {

using Json = nlohmann::ordered_json;

Json groups_json(const std::vector<ParticleGroup>& groups) {
    Json list = Json::array();
    for (const ParticleGroup& g : groups)
        list.push_back({{"name", g.name}, {"medium", static_cast<int>(g.medium)}, {"spacing", g.spacing}});
    return list;
}

Json planes_json(const std::vector<WallPlane>& planes) {
    Json list = Json::array();
    for (const WallPlane& p : planes) list.push_back({{"name", p.name}, {"point", p.point}, {"normal", p.normal}});
    return list;
}

/// Per medium: [low, high, least, most], or null.
Json field_json(const std::string& name, const FieldRanges& ranges) {
    Json media = Json::array();
    for (const FrameMedium medium : {FrameMedium::fluid, FrameMedium::solid, FrameMedium::wall}) {
        const auto range = ranges.of(name, medium);
        media.push_back(range ? Json{range->low, range->high, range->least, range->most} : Json());
    }
    return {{"name", name}, {"unit", std::string(field_unit(name))}, {"ranges", media}};
}

Json maps_json() {
    Json maps = Json::object();
    for (const ColorMap& map : color_maps()) maps[map.name] = map.color;
    return maps;
}

}  // namespace

RunView::RunView(const std::filesystem::path& directory, const FrameTable& first,
                 const std::vector<std::string>& fields)
    : folder_(read_run_folder(directory, first)), fields_(chosen_fields(first, folder_.dimension, fields)) {}

void RunView::add(const StoredFrame& frame) {
    ranges_.add(frame.table, folder_.dimension);
    frames_.push_back({frame.time, frame.step, frame.table.particles});
}

std::string RunView::pack(const StoredFrame& frame, int level) const {
    return pack_frame(frame, folder_.group_of(frame.table), {folder_.dimension, fields_, level});
}

std::string RunView::head(PageKind kind) const {
    Json json;
    json["version"] = std::string(program_version());
    json["live"] = kind != PageKind::stored;
    json["more"] = kind == PageKind::catching_up;
    json["title"] = folder_.title;
    json["directory"] = std::filesystem::absolute(folder_.directory).lexically_normal().string();
    json["status"] = kind == PageKind::stored ? folder_.status : run_status(folder_.directory);
    json["dimension"] = folder_.dimension;
    json["end"] = folder_.end;
    json["up"] = folder_.up;
    json["bounds"] = ranges_.bounds();
    json["groups"] = groups_json(folder_.groups);
    json["planes"] = planes_json(folder_.planes);
    json["fields"] = Json::array();
    std::vector<std::string> names = fields_;
    // The page makes it of the velocity's components.
    const bool has_velocity = std::find(names.begin(), names.end(), "velocity_x") != names.end();
    if (has_velocity && std::find(names.begin(), names.end(), "speed") == names.end())
        names.insert(names.begin(), "speed");
    for (const std::string& name : names) json["fields"].push_back(field_json(name, ranges_));
    json["maps"] = maps_json();
    json["frames"] = Json::array();
    for (const Frame& f : frames_) json["frames"].push_back({f.time, f.step, f.particles});
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace sluice
