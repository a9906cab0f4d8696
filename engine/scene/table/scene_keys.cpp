#include "engine/scene/table/scene_keys.hpp"

#include <algorithm>
#include <deque>
#include <string>

#include "engine/scene/effects/effect_table.hpp"
#include "engine/scene/table/key_rows.hpp"

namespace sluice {
namespace {

/// What may be said of each effect follows from the table of effects.
void add_effects(std::vector<SceneKey>& keys) {
    static std::deque<std::string> paths;  // which stay where they are
    for (const EffectInfo& info : effect_table) {
        paths.push_back("effects." + std::string(info.key));
        keys.push_back({paths.back(), KeyValue{.type = KeyType::word, .words = word_list<Switch>},
                        Otherwise{Otherwise::Kind::value, quoted_word<Switch::automatic>}, info.name, "", info.effect});
    }
}

std::vector<SceneKey> all_keys() {
    std::vector<SceneKey> keys;
    for (const SceneKey& key : key_rows()) {
        keys.push_back(key);
        if (key.path == "effects") add_effects(keys);
    }
    return keys;
}

/// Without "[0]".
std::string_view without_index(std::string_view part) { return part.substr(0, part.find('[')); }

}  // namespace

std::span<const SceneKey> scene_keys() {
    static const std::vector<SceneKey> keys = all_keys();
    return keys;
}

const SceneKey* find_scene_key(std::string_view table, std::string_view key) {
    for (const SceneKey& row : scene_keys())
        if (table_of(row) == table && (name_of(row) == key || name_of(row) == "*")) return &row;
    return nullptr;
}

std::string_view inner_pattern(const SceneKey& key) {
    const bool is_shape = key.value.type == KeyType::shape || key.value.type == KeyType::shapes;
    return is_shape ? "SHAPE" : key.path;
}

const SceneKey* resolve_scene_key(std::string_view path) {
    std::string_view table = path.starts_with("SHAPE.") ? path.substr(0, 5) : "";
    const SceneKey* row = nullptr;
    for (std::size_t start = table.empty() ? 0 : table.size() + 1; start <= path.size();) {
        const std::size_t end = std::min(path.find('.', start), path.size());
        row = find_scene_key(table, without_index(path.substr(start, end - start)));
        if (!row) return nullptr;
        table = inner_pattern(*row);
        start = end + 1;
    }
    return row;
}

std::vector<const SceneKey*> keys_named(std::string_view name) {
    std::vector<const SceneKey*> found;
    for (const SceneKey& row : scene_keys())
        if (name_of(row) == name) found.push_back(&row);
    return found;
}

}  // namespace sluice
