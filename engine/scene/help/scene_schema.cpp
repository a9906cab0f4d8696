#include "engine/scene/help/scene_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/scene/table/scene_keys.hpp"

namespace sluice {
namespace {

using Json = nlohmann::ordered_json;

Json object_of(std::string_view pattern);

Json array_of(Json items, int least, int most) {
    Json made = {{"type", "array"}, {"items", std::move(items)}, {"minItems", least}};
    if (most >= least) made["maxItems"] = most;
    return made;
}
constexpr int any_number = 0;  // of items

Json ranged(const char* type, const NumberRange& range) {
    Json made = {{"type", type}};
    if (std::isfinite(range.low)) made[range.open_low ? "exclusiveMinimum" : "minimum"] = range.low;
    if (std::isfinite(range.high)) made[range.open_high ? "exclusiveMaximum" : "maximum"] = range.high;
    return made;
}

Json type_of(const SceneKey& key) {
    const Json number = {{"type", "number"}}, text = {{"type", "string"}}, formula = {{"type", {"number", "string"}}};
    const Json shape = {{"$ref", "#/definitions/shape"}};
    switch (key.value.type) {
        case KeyType::text:
            return text;
        case KeyType::number:
            return ranged("number", key.value.range);
        case KeyType::whole:
            return ranged("integer", key.value.range);
        case KeyType::word:
            return {{"enum", choices_of(key)}};
        case KeyType::vector:
            return array_of(number, 2, 3);
        case KeyType::formula:
            return formula;
        case KeyType::formulas:
            return array_of(formula, 2, 3);
        case KeyType::station:
            return {{"anyOf", {number, array_of(number, 1, 3)}}};
        case KeyType::sides:
            return array_of(number, 2, 2);
        case KeyType::shape:
            return {{"allOf", Json::array({shape})}};
        case KeyType::shapes:
            return array_of(shape, 1, any_number);
        case KeyType::vertices:
            return array_of(array_of(number, 2, 2), 3, any_number);
        case KeyType::rows:
            return array_of(array_of(number, 3, 4), 2, any_number);
        case KeyType::texts:
            return array_of(text, 1, any_number);
        case KeyType::table:
        case KeyType::names:
            break;
    }
    return object_of(key.path);
}

Json schema_of(const SceneKey& key) {
    Json made = type_of(key);
    const Otherwise& otherwise = key.otherwise;
    std::string words(key.meaning);
    if (!key.value.unit.empty()) words += fmt::format(" [{}]", key.value.unit);
    if (otherwise.kind == Otherwise::Kind::required && key.only.empty()) words += "; required";
    if (otherwise.kind == Otherwise::Kind::said) words += fmt::format("; without it: {}", otherwise.text);
    if (otherwise.kind == Otherwise::Kind::value) made["default"] = Json::parse(otherwise.text);
    if (!otherwise.paper.empty())
        words += fmt::format("; {} with preset = {}", otherwise.paper, quoted_word<Preset::paper>);
    made["description"] = words;
    return made;
}

/// What a kind of a table's entries requires, and what belongs to other kinds.
Json rule_of_kind(std::string_view pattern, const std::string& kind) {
    Json required = Json::array(), properties = Json::object();
    for (const SceneKey& key : scene_keys()) {
        if (table_of(key) != pattern || key.only.empty()) continue;
        const std::vector<std::string> kinds = words_in(key.only);
        const auto has = [&](const std::string& name) { return std::count(kinds.begin(), kinds.end(), name) > 0; };
        if (has(kind) && key.otherwise.kind == Otherwise::Kind::required) required.push_back(name_of(key));
        if (!has(kind) && !has(kind + "?")) properties[std::string(name_of(key))] = false;
    }
    return {{"properties", properties}, {"required", required}};
}

/// Adds the rules of a table that has a `kind`, each in the `else` of the one before: with `allOf`, taplo would no
/// longer complete the table's keys.
void add_rules_of_kinds(std::string_view pattern, Json& table) {
    const SceneKey* kind = find_scene_key(pattern, "kind");
    if (!kind) return;
    Json* place = &table;
    for (const std::string& word : choices_of(*kind)) {
        if (place != &table || table.contains("if")) place = &(*place)["else"];
        (*place)["if"] = {{"properties", {{"kind", {{"const", word}}}}}, {"required", {"kind"}}};
        (*place)["then"] = rule_of_kind(pattern, word);
    }
}

Json object_of(std::string_view pattern) {
    Json made = {{"type", "object"}}, properties = Json::object(), required = Json::array();
    made["additionalProperties"] = false;
    for (const SceneKey& key : scene_keys()) {
        if (table_of(key) != pattern) continue;
        if (name_of(key) == "*") {
            made["additionalProperties"] = schema_of(key);
            continue;
        }
        properties[std::string(name_of(key))] = schema_of(key);
        if (key.otherwise.kind == Otherwise::Kind::required && key.only.empty()) required.push_back(name_of(key));
    }
    if (!properties.empty()) made["properties"] = std::move(properties);
    if (!required.empty()) made["required"] = std::move(required);
    add_rules_of_kinds(pattern, made);
    return made;
}

}  // namespace

std::string scene_schema() {
    Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "A scene of sluice"}};
    schema.update(object_of(""));
    Json shape = object_of("SHAPE");
    shape["minProperties"] = shape["maxProperties"] = 1;
    schema["definitions"] = {{"shape", shape}};
    return schema.dump(2) + "\n";
}

}  // namespace sluice
