#include "engine/scene/table/scene_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/scene/table/suggestion.hpp"

namespace sluice {
namespace {

bool is_finite(double end) { return std::abs(end) < std::numeric_limits<double>::infinity(); }

std::string in_brackets(const NumberRange& r) {
    return fmt::format("a number in {}{}, {}{}", r.open_low ? '(' : '[', r.low, r.high, r.open_high ? ')' : ']');
}

std::string plain_expectation(const SceneKey& key, int dimension) {
    const KeyValue& value = key.value;
    switch (value.type) {
        case KeyType::number:
            return value.range.text();
        case KeyType::whole:
            return fmt::format("a whole number from {} to {}", value.range.low, value.range.high);
        case KeyType::word:
            return one_of(choices_of(key));
        case KeyType::vector:
            return dimension == 2 ? "2 numbers [x, y]" : "3 numbers [x, y, z]";
        case KeyType::formula:
            return "a number or a formula in quotes";
        case KeyType::formulas:
            return fmt::format("an array of {} numbers or formulas", dimension);
        case KeyType::station:
            return dimension == 2 ? "a number x" : "2 numbers [x, z]";
        case KeyType::sides:
            return "an array of two numbers";
        case KeyType::shapes:
            return "an array of shapes";
        case KeyType::vertices:
            return "an array of vertices";
        case KeyType::rows:
            return fmt::format("an array of rows of {} numbers, time first", dimension + 1);
        case KeyType::texts:
            return "an array of texts in quotes";
        case KeyType::text:
            return "a text in quotes";
        case KeyType::shape:
        case KeyType::table:
        case KeyType::names:
            break;
    }
    return "a table";
}

}  // namespace

std::string NumberRange::text() const {
    if (!is_finite(low) && !is_finite(high)) return "a number";
    if (is_finite(low) && is_finite(high)) return in_brackets(*this);
    if (is_finite(low)) return fmt::format("a number {} {}", open_low ? ">" : ">=", low);
    return fmt::format("a number {} {}", open_high ? "<" : "<=", high);
}

std::string_view table_of(const SceneKey& key) {
    const std::size_t dot = key.path.find_last_of('.');
    return dot == std::string_view::npos ? std::string_view() : key.path.substr(0, dot);
}

std::string_view name_of(const SceneKey& key) { return key.path.substr(key.path.find_last_of('.') + 1); }

std::string shown_pattern(std::string_view pattern) {
    std::string shown;
    for (const char c : pattern) shown += c == '*' ? std::string("NAME") : std::string(1, c);
    return shown;
}

std::string shown_path(const SceneKey& key) { return shown_pattern(key.path); }

std::vector<std::string> words_in(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        if (end > start) words.emplace_back(text.substr(start, end - start));
        start = end + 1;
    }
    return words;
}

std::vector<std::string> choices_of(const SceneKey& key) { return {key.value.words.begin(), key.value.words.end()}; }

std::string expected_text(const SceneKey& key, int dimension) {
    const std::string text = plain_expectation(key, dimension);
    const bool has_unit = key.value.type == KeyType::number && !key.value.unit.empty();
    return has_unit ? fmt::format("{} [{}]", text, key.value.unit) : text;
}

}  // namespace sluice
