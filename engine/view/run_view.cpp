#include "engine/view/run_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/version.hpp"
#include "engine/view/color_map.hpp"

namespace sluice {
namespace {

/// In quotes.
std::string json_text(std::string_view text) {
    std::string safe = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') safe += '\\';
        safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return safe + '"';
}

/// [item, item …]
template <class Items, class Text>
std::string json_list(const Items& items, Text&& text) {
    std::string list = "[";
    for (const auto& item : items) {
        if (list.size() > 1) list += ',';
        list += text(item);
    }
    list += ']';
    return list;
}

std::string numbers(const Point& p) { return fmt::format("[{},{},{}]", p[0], p[1], p[2]); }

std::string group_json(const ParticleGroup& g) {
    return fmt::format(R"({{"name":{},"medium":{},"spacing":{}}})", json_text(g.name), static_cast<int>(g.medium),
                       g.spacing);
}

std::string plane_json(const WallPlane& p) {
    return fmt::format(R"({{"name":{},"point":{},"normal":{}}})", json_text(p.name), numbers(p.point),
                       numbers(p.normal));
}

/// Per medium: [low, high, least, most], or null.
std::string field_json(const std::string& name, const FieldRanges& ranges) {
    constexpr std::array media{FrameMedium::fluid, FrameMedium::solid, FrameMedium::wall};
    const std::string by_medium = json_list(media, [&](FrameMedium medium) -> std::string {
        const auto r = ranges.of(name, medium);
        return r ? fmt::format("[{},{},{},{}]", r->low, r->high, r->least, r->most) : "null";
    });
    return fmt::format(R"({{"name":{},"unit":{},"ranges":{}}})", json_text(name), json_text(field_unit(name)),
                       by_medium);
}

std::string maps_json() {
    std::string maps;
    for (const ColorMap& map : color_maps())
        maps += fmt::format(R"({}"{}":[{}])", maps.empty() ? '{' : ',', map.name, fmt::join(map.color, ","));
    maps += '}';
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
    std::vector<std::string> names = fields_;
    // The page makes it of the velocity's components.
    const auto has = [&names](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
    if (has("velocity_x") && !has("speed")) names.insert(names.begin(), "speed");
    const std::filesystem::path folder = std::filesystem::absolute(folder_.directory).lexically_normal();
    std::string json = "{";
    const auto add = [&json](const char* key, std::string_view value) {
        json += fmt::format(R"("{}":{},)", key, value);
    };
    add("version", json_text(program_version()));
    add("live", kind == PageKind::stored ? "false" : "true");
    add("more", kind == PageKind::catching_up ? "true" : "false");
    add("title", json_text(folder_.title));
    add("directory", json_text(folder.string()));
    add("status", json_text(kind == PageKind::stored ? folder_.status : run_status(folder_.directory)));
    add("dimension", fmt::format("{}", folder_.dimension));
    add("end", fmt::format("{}", folder_.end));
    add("up", numbers(folder_.up));
    add("bounds", json_list(ranges_.bounds(), [](const auto& b) { return fmt::format("[{},{}]", b.first, b.second); }));
    add("groups", json_list(folder_.groups, group_json));
    add("planes", json_list(folder_.planes, plane_json));
    add("fields", json_list(names, [this](const std::string& name) { return field_json(name, ranges_); }));
    add("maps", maps_json());
    json += fmt::format("\"frames\":{}}}", json_list(frames_, [](const Frame& f) {
                            return fmt::format("[{},{},{}]", f.time, f.step, f.particles);
                        }));
    return json;
}

}  // namespace sluice
