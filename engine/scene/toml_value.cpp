#include "engine/scene/toml_value.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "engine/scene/excerpt.hpp"
#include "engine/scene/suggestion.hpp"

namespace sluice {

// Copies of nodes carry no place, and overrides are put in as copies.
int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

TomlValue::TomlValue(const toml::node* node, std::string path, Scene& scene, std::string misspelt)
    : node_(node), path_(std::move(path)), scene_(&scene), misspelt_(std::move(misspelt)) {
    if (node_) scene_->lines[path_] = line_of(*node_);
}

double TomlValue::number(const NumberRule& rule) const {
    if (!node_ || !node_->is_number()) reject(rule.text);
    const double value =
        node_->is_integer() ? static_cast<double>(node_->as_integer()->get()) : node_->as_floating_point()->get();
    if (!std::isfinite(value)) reject("a finite number");
    if (!rule.holds(value)) reject(rule.text);
    return value;
}

int TomlValue::integer(IntegerRange range) const {
    const std::string expected = fmt::format("a whole number from {} to {}", range.min, range.max);
    if (!node_ || !node_->is_integer()) reject(expected);
    const std::int64_t value = node_->as_integer()->get();
    if (value < range.min || value > range.max) reject(expected);
    return static_cast<int>(value);
}

std::string TomlValue::text() const {
    if (!node_ || !node_->is_string()) reject("a text in quotes");
    return node_->as_string()->get();
}

std::size_t TomlValue::choice(const std::vector<std::string>& options) const {
    if (!node_ || !node_->is_string()) reject(one_of(options));
    const std::string word = text();
    for (std::size_t i = 0; i < options.size(); ++i)
        if (options[i] == word) return i;
    reject(one_of(options) + did_you_mean(word, options));
}

Point TomlValue::point() const {
    const auto size = static_cast<std::size_t>(scene_->dimension);
    const std::string_view expected = size == 2 ? "2 numbers [x, y]" : "3 numbers [x, y, z]";
    const std::vector<TomlValue> values = items(expected);
    if (values.size() != size) reject(expected);
    Point p{};
    for (std::size_t k = 0; k < size; ++k) p[k] = values[k].number();
    return p;
}

std::vector<TomlValue> TomlValue::items(std::string_view expected) const {
    if (!node_ || !node_->is_array()) reject(expected);
    std::vector<TomlValue> values;
    for (const toml::node& item : *node_->as_array())
        values.emplace_back(&item, fmt::format("{}[{}]", path_, values.size()), *scene_);
    return values;
}

std::string TomlValue::found() const {
    if (!node_) return "nothing";
    if (const auto* text = node_->as_string()) return fmt::format("\"{}\"", excerpt(text->get()));
    if (const auto* integer = node_->as_integer()) return fmt::format("{}", integer->get());
    if (const auto* real = node_->as_floating_point()) return fmt::format("{}", real->get());
    if (const auto* flag = node_->as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* array = node_->as_array())
        return array->size() == 1 ? "an array of 1 value" : fmt::format("an array of {} values", array->size());
    if (node_->is_table()) return "a table";
    return "a date or time";
}

void TomlValue::reject(std::string_view expected) const {
    if (!node_ && !misspelt_.empty()) {
        const std::string key = path_.substr(path_.find_last_of('.') + 1);
        const std::string prefix = path_.substr(0, path_.size() - key.size());
        scene_->fail(prefix + misspelt_,
                     fmt::format("found an unknown key, expected \"{0}\"; did you mean \"{0}\"?", key));
    }
    fail(fmt::format("found {}, expected {}", found(), expected));
}

void TomlValue::fail(const std::string& message) const { scene_->fail(path_, message); }

}  // namespace sluice
