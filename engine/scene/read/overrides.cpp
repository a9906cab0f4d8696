#include "engine/scene/read/overrides.hpp"

#include <fmt/format.h>

#include <cctype>
#include <optional>

#include "engine/scene/scene.hpp"
#include "engine/scene/table/excerpt.hpp"
#include "engine/scene/table/scene_keys.hpp"
#include "engine/scene/table/suggestion.hpp"

namespace sluice {
namespace {

struct Override {
    std::string text;  ///< as given
    std::vector<std::string> keys;
    std::string value;
};

[[noreturn]] void fail(const std::string& file, const std::string& text, const std::string& message) {
    throw SceneError(fmt::format("{}: --set {}: {}", file, excerpt(text), excerpt(message, 4000)));
}

Override split(const std::string& text, const std::string& file) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) fail(file, text, "found no '=', expected key.path=value");
    Override change{text, {}, text.substr(equals + 1)};
    const std::string path = text.substr(0, equals);
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find('.', start), path.size());
        if (end == start) fail(file, text, "found an empty key, expected key.path=value");
        change.keys.push_back(path.substr(start, end - start));
        start = end + 1;
    }
    return change;
}

/// A table with the value under "value"; none if the text is not TOML.
std::optional<toml::table> parse_value(const std::string& text) {
    try {
        toml::table parsed = toml::parse("value = " + text);
        if (parsed.size() == 1 && parsed.contains("value")) return parsed;
    } catch (const toml::parse_error&) {
        // A bare word, or an error; the caller tells them apart.
    }
    return std::nullopt;
}

/// Shells eat quotes, so a text that starts with a letter needs none.
bool is_bare_word(const std::string& text) {
    return !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) != 0 || text[0] == '_');
}

std::vector<std::string> names_in(const toml::table& table) {
    std::vector<std::string> names;
    for (const auto& [key, node] : table) names.emplace_back(key.str());
    return names;
}

/// In a table of the user's own names a misspelt name would not be noticed, or would be taken for a new body.
void check_name(const toml::table& root, const Override& change, const std::string& file) {
    const std::string& kind = change.keys[0];
    const SceneKey* named = find_scene_key(kind, "*");
    if (!named || change.keys.size() <= (named->value.type == KeyType::table ? 2 : 1)) return;
    const toml::table* table = root[kind].as_table();
    const std::string& name = change.keys[1];
    if (table && table->contains(name)) return;
    const std::vector<std::string> names = table ? names_in(*table) : std::vector<std::string>{};
    fail(file, change.text,
         fmt::format("found no \"{}\" in {}, expected {}{}", name, kind, one_of(names), did_you_mean(name, names)));
}

/// The table that the last key belongs in; made if the file leaves it out.
toml::table& table_of(toml::table& root, const Override& change, const std::string& file) {
    toml::table* table = &root;
    std::string path;
    for (std::size_t i = 0; i + 1 < change.keys.size(); ++i) {
        path += (i ? "." : "") + change.keys[i];
        if (!table->contains(change.keys[i])) table->insert(change.keys[i], toml::table{});
        toml::table* next = table->get(change.keys[i])->as_table();
        if (!next) fail(file, change.text, fmt::format("found a value at {}, expected a table", path));
        table = next;
    }
    return *table;
}

}  // namespace

void apply_overrides(toml::table& root, const std::vector<std::string>& overrides, const std::string& file) {
    for (const std::string& text : overrides) {
        const Override change = split(text, file);
        check_name(root, change, file);
        toml::table& table = table_of(root, change, file);
        const std::string& key = change.keys.back();
        const std::optional<toml::table> parsed = parse_value(change.value);
        if (!parsed && !is_bare_word(change.value))
            fail(file, text, fmt::format("found \"{}\", expected a TOML value or a word", change.value));
        // Assigned as copies, since a moved node would bring a line of its own along.
        if (parsed)
            parsed->get("value")->visit([&](const auto& node) { table.insert_or_assign(key, node); });
        else
            table.insert_or_assign(key, change.value);
    }
}

}  // namespace sluice
