#include "engine/scene/read/canonical_text.hpp"

#include <algorithm>
#include <functional>
#include <sstream>
#include <string_view>
#include <vector>

#include "engine/scene/read/toml_table.hpp"
#include "engine/scene/table/scene_keys.hpp"

namespace sluice {
namespace {

/// Tables of the user's own names.
bool keeps_order(std::string_view table) { return find_scene_key(table, "*") != nullptr; }

/// Tables up to this depth get a heading of their own, deeper ones are written within a line.
constexpr int deepest_heading = 2;

void write_inline(toml::node& node) {
    if (toml::table* table = node.as_table()) {
        table->is_inline(true);
        for (auto&& [key, inner] : *table) write_inline(inner);
    } else if (toml::array* array = node.as_array())
        for (toml::node& inner : *array) write_inline(inner);
}

/// `key = value`, as the library writes it. An empty table makes `[key]`.
std::string written(std::string_view key, const toml::node& node) {
    toml::table line;
    node.visit([&](const auto& value) { line.insert(key, value); });
    write_inline(*line.get(key));
    std::ostringstream text;
    text << toml::toml_formatter(line);
    return text.str();
}

void write_table(const toml::table& table, const std::string& path, int depth, std::string& text) {
    const bool ordered = depth == 1 && keeps_order(path);
    std::vector<std::string> keys = keys_in_file_order(table);
    if (!ordered) std::sort(keys.begin(), keys.end());
    const auto has_heading = [&](const std::string& key) {
        return depth < deepest_heading && table.get(key)->is_table();
    };
    const auto first_table = std::stable_partition(keys.begin(), keys.end(), std::not_fn(has_heading));
    // What holds nothing but tables needs no heading.
    if (!path.empty() && (first_table != keys.begin() || keys.empty())) text += "\n[" + path + "]\n";
    for (auto key = keys.begin(); key != first_table; ++key) text += written(*key, *table.get(*key)) + "\n";
    for (auto key = first_table; key != keys.end(); ++key)
        write_table(*table.get(*key)->as_table(), path.empty() ? *key : path + "." + *key, depth + 1, text);
}

}  // namespace

std::string canonical_text(toml::table root) {
    root.erase("reference");
    std::string text;
    write_table(root, "", 0, text);
    return text;
}

}  // namespace sluice
