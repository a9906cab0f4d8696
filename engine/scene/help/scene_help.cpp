#include "engine/scene/help/scene_help.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/table/scene_keys.hpp"

namespace sluice {
namespace {

constexpr std::string_view shape_heading = "SHAPE", effects_table = "effects";

std::string with_unit(const std::string& text, const SceneKey& key) {
    return key.value.unit.empty() ? text : fmt::format("{} [{}]", text, key.value.unit);
}

std::string variables_of(const SceneKey& key) {
    return fmt::format("{}", fmt::join(words_in(word_of(key.value.variables)), ", "));
}

/// What may stand behind the `=`.
std::string value_text(const SceneKey& key) {
    switch (key.value.type) {
        case KeyType::vector:
            return with_unit("[x, y], in 3D [x, y, z]", key);
        case KeyType::formula:
            return with_unit("a number, or a formula in " + variables_of(key), key);
        case KeyType::formulas:
            return with_unit("[x, y], in 3D [x, y, z]: numbers or formulas in " + variables_of(key), key);
        case KeyType::station:
            return with_unit("[x, y], in 3D [x, y, z]; a number or [x], in 3D [x, z]", key);
        case KeyType::sides:
            return with_unit("[low, high]", key);
        case KeyType::shape:
            return "a shape";
        case KeyType::vertices:
            return with_unit("[[x, y], ...]", key);
        case KeyType::rows:
            return with_unit("[[t, x, y], ...], in 3D [[t, x, y, z], ...]", key);
        case KeyType::names:
            return "a table of names";
        case KeyType::text:
        case KeyType::number:
        case KeyType::whole:
        case KeyType::word:
        case KeyType::shapes:
        case KeyType::texts:
        case KeyType::table:
            break;
    }
    return expected_text(key, 2);
}

/// "0.75; 0.9 with preset = "paper"".
std::string otherwise_text(const SceneKey& key) {
    const Otherwise& otherwise = key.otherwise;
    if (otherwise.kind == Otherwise::Kind::required) return "required";
    if (otherwise.paper.empty()) return std::string(otherwise.text);
    return fmt::format("{}; {} with preset = {}", otherwise.text, otherwise.paper, quoted_word<Preset::paper>);
}

/// When it applies; empty = always.
std::string only_text(const SceneKey& key) {
    if (key.only.empty() || !find_scene_key(table_of(key), "kind")) return std::string(key.only);
    std::string text;
    for (std::string word : words_in(key.only)) {
        if (word.ends_with('?')) word.pop_back();
        text += fmt::format("{}\"{}\"", text.empty() ? "kind = " : " or ", word);
    }
    return text;
}

std::string row(std::string_view name, std::string_view value) {
    return value.empty() ? "" : fmt::format("  {:<10}{}\n", name, value);
}

bool is_table(const SceneKey& key) { return key.value.type == KeyType::table || key.value.type == KeyType::names; }

/// Keys with a value of their own, table by table; `visit(pattern, rows)`.
template <class Visit>
void for_each_table(Visit visit) {
    std::vector<std::string_view> patterns;
    for (const SceneKey& key : scene_keys()) {
        const std::string_view table = table_of(key);
        if (std::find(patterns.begin(), patterns.end(), table) == patterns.end()) patterns.push_back(table);
    }
    for (const std::string_view pattern : patterns) {
        std::vector<const SceneKey*> rows;
        for (const SceneKey& key : scene_keys())
            if (table_of(key) == pattern && !(is_table(key) && name_of(key) == "*")) rows.push_back(&key);
        if (!rows.empty()) visit(pattern, rows);
    }
}

std::string heading(std::string_view pattern) {
    if (pattern.empty()) return "top of the file";
    if (pattern == shape_heading) return "SHAPE = {...}, one of";
    if (pattern.starts_with(shape_heading))
        return fmt::format("{} = {{...}}", pattern.substr(shape_heading.size() + 1));
    return fmt::format("[{}]", shown_pattern(pattern));
}

std::string document_heading(std::string_view pattern) {
    if (pattern.empty()) return "Top of the file";
    if (pattern == shape_heading) return "Shapes";
    if (pattern.starts_with(shape_heading))
        return fmt::format("`{} = {{...}}`", pattern.substr(shape_heading.size() + 1));
    return fmt::format("`[{}]`", shown_pattern(pattern));
}

std::string key_name(const SceneKey& key) {
    return name_of(key) == "*" ? std::string("NAME") : std::string(name_of(key));
}

/// A vertical bar would end a cell of Markdown.
std::string cell(std::string_view text) {
    std::string safe;
    for (const char c : text) safe += c == '|' ? std::string("\\|") : std::string(1, c);
    return safe;
}

std::string document_row(const SceneKey& key) {
    const std::string only = only_text(key);
    std::string meaning = std::string(key.meaning) + (only.empty() ? "" : " (" + only + ")");
    if (key.effect && table_of(key) != "effects") meaning += fmt::format("; effect `{}`", info_of(*key.effect).key);
    const std::string value = is_table(key) ? "table" : value_text(key);
    return fmt::format("| `{}` | {} | {} | {} |\n", key_name(key), cell(value), cell(otherwise_text(key)),
                       cell(meaning));
}

}  // namespace

std::string scene_key_list() {
    std::string text;
    for_each_table([&](std::string_view pattern, const std::vector<const SceneKey*>& rows) {
        text += fmt::format("{}{}\n", text.empty() ? "" : "\n", heading(pattern));
        for (const SceneKey* key : rows) text += fmt::format("  {:<28}{}\n", key_name(*key), key->meaning);
    });
    return text +
           "\n`sluice help scene KEY` shows a key's values, unit and default; KEY is a name or a path, as spacing,\n"
           "method.fluid or bodies.NAME.shape. `sluice help schema` prints a JSON schema that editors complete with.\n";
}

std::string scene_key_page(const SceneKey& key) {
    std::string text = fmt::format("{}\n", shown_path(key)) + row("what", key.meaning) + row("value", value_text(key)) +
                       row("without", otherwise_text(key)) + row("only", only_text(key));
    if (key.effect) text += row("effect", fmt::format("`sluice help effects {}`", info_of(*key.effect).key));
    const std::string_view inside = inner_pattern(key);
    const bool is_map = key.value.type == KeyType::names;
    if (!is_table(key) && key.value.type != KeyType::shape) return text;
    for (const SceneKey& other : scene_keys())
        if (table_of(other) == (is_map ? std::string(inside) + ".*" : std::string(inside)))
            text += fmt::format("    {:<28}{}\n", key_name(other), other.meaning);
    return text;
}

std::vector<const SceneKey*> meant_scene_keys(std::string_view text) {
    for (const SceneKey& key : scene_keys())
        if (shown_path(key) == text) return {&key};
    if (const SceneKey* key = resolve_scene_key(text)) return {key};
    return keys_named(text);
}

std::vector<std::string> scene_key_names() {
    std::vector<std::string> names;
    for (const SceneKey& key : scene_keys()) {
        names.push_back(shown_path(key));
        if (name_of(key) != "*") names.emplace_back(name_of(key));
    }
    return names;
}

std::string scene_document() {
    std::string text =
        "# Scenes\n\n"
        "Printed by `sluice help scene --markdown` from the table of keys that the reader takes types, ranges and "
        "choices\n"
        "from (`engine/scene/table/key_rows.cpp`); a test checks that it is up to date.\n\n"
        "A scene is a [TOML](https://toml.io) file in SI units. `NAME` is a name of yours. `sluice new` writes scenes "
        "to "
        "start from;\n"
        "`sluice help schema` prints a JSON schema, with which editors complete and check scenes.\n";
    for_each_table([&](std::string_view pattern, const std::vector<const SceneKey*>& rows) {
        const std::string title = document_heading(pattern);
        text += fmt::format("\n## {}\n\n", title);
        if (pattern == effects_table) {
            text +=
                "Each effect is \"auto\" unless a scene says \"on\" or \"off\": [EFFECTS.md](EFFECTS.md) lists them.\n";
            return;
        }
        if (pattern == shape_heading)
            text += "`{box = {min = [0, 0], max = [1, 1]}}`: one of these keys, with what is in it.\n\n";
        text += "| key | value | without it | meaning |\n| --- | --- | --- | --- |\n";
        for (const SceneKey* key : rows) text += document_row(*key);
    });
    return text;
}

}  // namespace sluice
