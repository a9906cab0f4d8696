#include "engine/scene/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "engine/scene/suggestion.hpp"

namespace sluice {

std::vector<std::string> keys_in_file_order(const toml::table& table) {
    using Place = std::tuple<std::uint32_t, std::uint32_t, std::string>;
    constexpr auto last = std::numeric_limits<std::uint32_t>::max();
    std::vector<Place> places;
    for (const auto& [key, node] : table) {
        const auto& at = key.source().begin;
        places.emplace_back(at.line == 0 ? last : at.line, at.column, std::string(key.str()));
    }
    std::sort(places.begin(), places.end());
    std::vector<std::string> names;
    for (const Place& place : places) names.push_back(std::get<2>(place));
    return names;
}

TomlTable::TomlTable(const toml::table& root, Scene& scene) : table_(&root), scene_(&scene) {}

TomlTable::TomlTable(const TomlValue& value) : path_(value.path()), scene_(&value.scene()) {
    if (!value || !value.node()->is_table()) value.reject("a table");
    table_ = value.node()->as_table();
}

TomlValue TomlTable::get(const std::string& key) {
    if (!was_asked(key)) asked_.push_back(key);
    if (const toml::node* node = table_->get(key)) return {node, path_of(key), *scene_};
    const std::string misspelt = misspelling_of(key);
    if (!misspelt.empty()) scene_->lines[path_of(misspelt)] = line_of(*table_->get(misspelt));
    return {nullptr, path_of(key), *scene_, misspelt};
}

std::vector<std::string> TomlTable::keys() const { return keys_in_file_order(*table_); }

void TomlTable::finish() const {
    for (const std::string& key : keys()) {
        if (was_asked(key)) continue;
        scene_->lines[path_of(key)] = line_of(*table_->get(key));
        scene_->fail(path_of(key),
                     fmt::format("found an unknown key, expected {}{}", one_of(asked_), did_you_mean(key, asked_)));
    }
}

bool TomlTable::was_asked(const std::string& key) const {
    return std::find(asked_.begin(), asked_.end(), key) != asked_.end();
}

std::string TomlTable::misspelling_of(const std::string& key) const {
    for (const std::string& present : keys())
        if (!was_asked(present) && !nearest(present, {key}).empty()) return present;
    return "";
}

}  // namespace sluice
