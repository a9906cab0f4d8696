#include "engine/scene/read/toml_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/scene/table/excerpt.hpp"
#include "engine/scene/table/suggestion.hpp"

namespace sluice {

namespace {

/// Short arrays of numbers are shown, so that a comma in place of a point is seen.
std::string found_array(const toml::array& array) {
    constexpr std::size_t most = 4;
    std::string values;
    for (const toml::node& item : array) {
        const auto number = item.value<double>();
        if (!number || array.size() > most)
            return fmt::format("an array of {} value{}", array.size(), array.size() == 1 ? "" : "s");
        values += fmt::format("{}{}", values.empty() ? "" : ", ", *number);
    }
    return fmt::format("[{}]", values);
}

}  // namespace

// Copies of nodes carry no place, and overrides are put in as copies.
int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

TomlValue::TomlValue(const toml::node* node, std::string path, Scene& scene, const SceneKey& key, std::string misspelt)
    : node_(node), path_(std::move(path)), scene_(&scene), key_(&key), misspelt_(std::move(misspelt)) {
    if (node_) scene_->lines[path_] = line_of(*node_);
}

TomlValue::TomlValue(const TomlValue& array, const toml::node& item, std::size_t index)
    : TomlValue(&item, fmt::format("{}[{}]", array.path_, index), *array.scene_, *array.key_) {
    is_item_ = true;
}

void TomlValue::must_be(std::initializer_list<KeyType> types) const {
    if (std::find(types.begin(), types.end(), key_->value.type) == types.end()) refuse_type();
}

void TomlValue::refuse_type() const {
    throw std::logic_error(fmt::format("{} is read as another type than the table of keys has", path_));
}

double TomlValue::number() const {
    if (!is_item_) must_be({KeyType::number, KeyType::formula, KeyType::station});
    if (!node_ || !node_->is_number()) reject();
    const double value =
        node_->is_integer() ? static_cast<double>(node_->as_integer()->get()) : node_->as_floating_point()->get();
    if (!std::isfinite(value)) reject("a finite number");
    if (!is_item_ && !key_->value.range.holds(value)) reject();
    return value;
}

int TomlValue::whole() const {
    must_be({KeyType::whole});
    if (!node_ || !node_->is_integer()) reject();
    const std::int64_t value = node_->as_integer()->get();
    if (!key_->value.range.holds(static_cast<double>(value))) reject();
    return static_cast<int>(value);
}

std::string TomlValue::text() const {
    if (!is_item_) must_be({KeyType::text, KeyType::formula});
    if (!node_ || !node_->is_string()) reject(is_item_ ? "a text in quotes" : expected());
    return node_->as_string()->get();
}

std::size_t TomlValue::index_of_word(std::span<const std::string_view> words) const {
    must_be({KeyType::word});
    if (words.data() != key_->value.words.data()) refuse_type();
    return index_in(choices_of(*key_));
}

std::size_t TomlValue::name(const std::vector<std::string>& names) const {
    must_be({KeyType::text});
    return index_in(names);
}

std::size_t TomlValue::index_in(const std::vector<std::string>& options) const {
    if (!node_ || !node_->is_string()) reject(one_of(options));
    const std::string word = node_->as_string()->get();
    for (std::size_t i = 0; i < options.size(); ++i)
        if (options[i] == word) return i;
    reject(one_of(options) + did_you_mean(word, options));
}

Point TomlValue::point() const {
    must_be({KeyType::vector, KeyType::station});
    const auto size = static_cast<std::size_t>(scene_->dimension);
    const std::string expected = size == 2 ? "2 numbers [x, y]" : "3 numbers [x, y, z]";
    const std::vector<TomlValue> values = items(expected);
    if (size == 2 && values.size() == 3) reject(expected + ", or dimension = 3 at the top of the file");
    if (values.size() != size) reject(expected);
    Point p{};
    for (std::size_t k = 0; k < size; ++k) p[k] = values[k].number();
    return p;
}

std::vector<TomlValue> TomlValue::items(std::string_view expected) const {
    if (!is_item_)
        must_be({KeyType::vector, KeyType::formulas, KeyType::station, KeyType::sides, KeyType::shapes,
                 KeyType::vertices, KeyType::rows, KeyType::texts});
    if (!node_ || !node_->is_array()) reject(expected.empty() ? this->expected() : std::string(expected));
    std::vector<TomlValue> values;
    for (const toml::node& item : *node_->as_array()) values.push_back({*this, item, values.size()});
    return values;
}

std::string TomlValue::expected() const { return is_item_ ? "a number" : expected_text(*key_, scene_->dimension); }

std::string TomlValue::found() const {
    if (!node_) return "nothing";
    if (const auto* text = node_->as_string()) return fmt::format("\"{}\"", excerpt(text->get()));
    if (const auto* integer = node_->as_integer()) return fmt::format("{}", integer->get());
    if (const auto* real = node_->as_floating_point()) return fmt::format("{}", real->get());
    if (const auto* flag = node_->as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* array = node_->as_array()) return found_array(*array);
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
    // What is missing may be new to its reader.
    const std::string what = node_ || key_->value.type == KeyType::names ? "" : fmt::format(": {}", key_->meaning);
    fail(fmt::format("found {}, expected {}{}", found(), expected, what));
}

void TomlValue::fail(const std::string& message) const { scene_->fail(path_, message); }

}  // namespace sluice
