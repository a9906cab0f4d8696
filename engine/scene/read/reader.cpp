#include <fmt/format.h>
#include <toml++/toml.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "engine/scene/formula.hpp"
#include "engine/scene/light_solid.hpp"
#include "engine/scene/read/canonical_text.hpp"
#include "engine/scene/read/key_parts.hpp"
#include "engine/scene/read/overrides.hpp"
#include "engine/scene/read/reader_parts.hpp"
#include "engine/scene/read/syntax_error.hpp"
#include "engine/scene/read/toml_table.hpp"

namespace sluice {
namespace {

/// Of a scene file: a motion of some hundred thousand rows.
constexpr std::size_t most_bytes = std::size_t{32} << 20;

std::string read_text(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw SceneError(fmt::format("{}: found a folder, expected a scene file", path));
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw SceneError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    std::string text, piece(1 << 16, '\0');
    while (stream && text.size() <= most_bytes) {  // a device or a pipe may have no end
        stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        text.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    }
    if (text.size() > most_bytes)
        throw SceneError(fmt::format("{}: found more than {} MB, expected a scene file", path, most_bytes >> 20));
    return text;
}

toml::table parse(const std::string& text, const std::string& path) {
    if (const int line = line_of_long_key(text))
        throw SceneError(fmt::format("{}:{}:1: found a key of more than {} parts, expected a scene's key", path, line,
                                     most_key_parts));
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        const auto& at = error.source().begin;
        throw SceneError(
            fmt::format("{}:{}", path, explain_syntax_error(text, {at.line, at.column}, error.description())));
    }
}

void read_constants(TomlTable& root) {
    const TomlValue value = root.get("constants");
    if (!value) return;
    TomlTable table(value);
    for (const std::string& name : table.keys()) {
        const TomlValue constant = table.get(name);
        const std::string problem = constant_name_problem(name);
        if (!problem.empty()) constant.fail(fmt::format("found {}, expected a new name for the constant", problem));
        root.scene().constants[name] = constant.number();
    }
}

std::pair<double, double> read_sides(const TomlValue& value) {
    const std::vector<TomlValue> sides = value.items();
    if (sides.size() != 2) value.reject();
    const double low = sides[0].number(), high = sides[1].number();
    if (!(low < high)) value.fail(fmt::format("found [{}, {}], expected the lower side first", low, high));
    return {low, high};
}

void read_output(TomlTable& root) {
    TomlTable table(root.get("output"));
    OutputTimes& output = root.scene().output;
    output.end = table.get("end").number();
    if (const auto v = table.get("frame_interval")) output.frame_interval = v.number();
    if (const auto v = table.get("probe_interval")) output.probe_interval = v.number();
    if (const auto v = table.get("checkpoint_interval")) output.checkpoint_interval = v.number();
    if (const auto v = table.get("checkpoint_minutes")) output.checkpoint_minutes = v.number();
    table.finish();
}

void read_watch(TomlTable& root) {
    const TomlValue value = root.get("watch");
    if (!value) return;
    TomlTable table(value);
    if (const auto v = table.get("policy")) root.scene().watch = v.choice<WatchPolicy>();
    table.finish();
}

void read_scene(TomlTable& root) {
    Scene& scene = root.scene();
    if (const auto v = root.get("title")) scene.title = v.text();
    if (const auto v = root.get("dimension")) scene.dimension = v.whole();
    if (const auto v = root.get("gravity")) scene.gravity = v.point();
    read_constants(root);
    if (const auto v = root.get("acceleration")) scene.acceleration = read_formulas(v);
    read_domain(root);
    read_method(root);
    read_effects(root);
    read_materials(root);
    read_bodies(root);
    damp_light_solid(scene);
    read_walls(root);
    read_probes(root);
    read_watch(root);
    read_output(root);
    read_references(root);
    root.finish();
}

}  // namespace

void read_domain(TomlTable& root) {
    const TomlValue value = root.get("domain");
    if (!value) return;
    TomlTable table(value);
    if (const auto periodic = table.get("periodic")) {
        TomlTable axes(periodic);
        for (std::size_t k = 0; k < static_cast<std::size_t>(root.scene().dimension); ++k)
            if (const auto sides = axes.get(std::string(1, "xyz"[k]))) root.scene().periodic[k] = read_sides(sides);
        axes.finish();
    }
    table.finish();
}

Scene load_scene(const std::string& path, const std::vector<std::string>& overrides) {
    return parse_scene(read_text(path), path, overrides);
}

Scene parse_scene(const std::string& text, const std::string& name, const std::vector<std::string>& overrides) {
    toml::table table = parse(text, name);
    apply_overrides(table, overrides, name);
    Scene scene;
    scene.file = name;
    scene.source = canonical_text(table);
    TomlTable root(table, scene);
    read_scene(root);
    return scene;
}

}  // namespace sluice
