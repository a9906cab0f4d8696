#include "engine/scene/read/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "engine/scene/table/scene_keys.hpp"
#include "engine/scene/table/suggestion.hpp"

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

namespace {

/// "of walls whose kind is "mirror"", for a key that its table has under other circumstances.
std::string owner_of(const SceneKey& key) {
    std::string kinds;
    for (std::string word : words_in(key.only)) {
        if (word.ends_with('?')) word.pop_back();
        kinds += fmt::format("{}\"{}\"", kinds.empty() ? "" : " or ", word);
    }
    const std::string_view table = table_of(key);
    const bool has_kinds = find_scene_key(table, "kind") != nullptr;
    return has_kinds ? fmt::format("of {} whose kind is {}", table.substr(0, table.find('.')), kinds)
                     : fmt::format("of {} scenes", key.only);
}

/// Where a key belongs that its table does not know: keys written below the wrong heading are found so.
std::string other_places(const std::string& key) {
    std::string places;
    for (const SceneKey* row : keys_named(key)) {
        const std::string table = shown_pattern(table_of(*row));
        const std::string place = table.empty() ? "the top of the file, before the first [table]" : "[" + table + "]";
        places += (places.empty() ? "" : " or ") + place;
    }
    return places.empty() ? "" : fmt::format("; \"{}\" belongs in {}", key, places);
}

}  // namespace

TomlTable::TomlTable(const toml::table& root, Scene& scene) : table_(&root), scene_(&scene) {}

TomlTable::TomlTable(const TomlValue& value)
    : path_(value.path()), pattern_(inner_pattern(value.key())), scene_(&value.scene()) {
    if (!value || !value.node()->is_table()) value.reject("a table");
    table_ = value.node()->as_table();
}

TomlValue TomlTable::get(const std::string& key) {
    const SceneKey* row = find_scene_key(pattern_, key);
    if (!row) throw std::logic_error(fmt::format("{} is not in the table of keys", path_of(key)));
    if (!was_asked(key)) asked_.push_back(key);
    if (const toml::node* node = table_->get(key)) return {node, path_of(key), *scene_, *row};
    const std::string misspelt = misspelling_of(key);
    if (!misspelt.empty()) scene_->lines[path_of(misspelt)] = line_of(*table_->get(misspelt));
    return {nullptr, path_of(key), *scene_, *row, misspelt};
}

std::vector<std::string> TomlTable::keys() const { return keys_in_file_order(*table_); }

void TomlTable::finish() const {
    for (const std::string& key : keys()) {
        if (was_asked(key)) continue;
        scene_->lines[path_of(key)] = line_of(*table_->get(key));
        scene_->fail(path_of(key), unknown_key(key));
    }
}

std::string TomlTable::unknown_key(const std::string& key) const {
    const std::string expected = one_of(asked_);
    if (const SceneKey* row = find_scene_key(pattern_, key))
        return fmt::format("found a key {}, expected {}", owner_of(*row), expected);
    const std::string nearest_here = did_you_mean(key, asked_);
    if (!nearest_here.empty()) return fmt::format("found an unknown key, expected {}{}", expected, nearest_here);
    return fmt::format("found an unknown key, expected {}{}", expected, other_places(key));
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
