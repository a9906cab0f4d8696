#include "engine/study/matrix.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <sstream>
#include <type_traits>

#include "engine/base/text_hash.hpp"
#include "engine/scene/method_keys.hpp"

namespace sluice {
namespace {

[[noreturn]] void fail(const Scene& scene, const std::string& text, const std::string& message) {
    throw SceneError(fmt::format("{}: --vary {}: {}", scene.file, text, message));
}

std::optional<double> number_in(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// At the commas that stand outside brackets and quotes.
std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    bool quoted = false;
    for (const char c : text) {
        if (c == '"') quoted = !quoted;
        if (!quoted && (c == '[' || c == '{')) ++depth;
        if (!quoted && (c == ']' || c == '}')) --depth;
        if (c == ',' && depth == 0 && !quoted)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

/// x0.5 as a number; other values as they are.
std::string resolve(const std::string& value, const std::string& key, const std::string& text, const Scene& scene) {
    if (value.size() < 2 || value[0] != 'x') return value;
    const std::optional<double> factor = number_in(value.substr(1));
    if (!factor) return value;  // a word that starts with x
    if (!(*factor > 0)) fail(scene, text, fmt::format("found the factor {}, expected a number > 0", value));
    const std::optional<double> base = number_in(value_in_scene(scene, key));
    if (!base) fail(scene, text, fmt::format("found the factor {}, but the scene has no number at {}", value, key));
    return fmt::format("{:.12g}", *factor * *base);  // what is beyond is rounding of the product
}

/// A node as text: words without their quotes.
std::string text_of(const toml::node& node) {
    if (const auto* word = node.as_string()) return word->get();
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    return text.str();
}

std::string text_of(double value) { return fmt::format("{}", value); }
std::string text_of(int value) { return fmt::format("{}", value); }
std::string text_of(const std::optional<double>& value) { return value ? text_of(*value) : ""; }
template <class Enum>
requires std::is_enum_v<Enum> std::string text_of(Enum value) { return std::string(word_of(value)); }

/// What the method has at a key of [method], as the file or the preset has set it; empty without it.
std::string from_method(const Method& method, std::string_view key) {
    std::string found;
    const auto look_in = [&](std::string_view table) {
        return [&, table](std::string_view name, const auto& value) {
            if (key.starts_with(table) && key.substr(table.size()) == name) found = text_of(value);
        };
    };
    for_each_method_key(method, look_in(""));
    for_each_fluid_key(method.fluid, look_in("fluid."));
    for_each_solid_key(method.solid, look_in("solid."));
    return found;
}

/// Takes out a key; tables that become empty go with it, so that an absent one is the same.
void erase(toml::table& table, std::string_view path) {
    const std::size_t dot = path.find('.');
    if (dot == std::string_view::npos) {
        table.erase(path);
        return;
    }
    toml::table* inner = table[path.substr(0, dot)].as_table();
    if (!inner) return;
    erase(*inner, path.substr(dot + 1));
    if (inner->empty()) table.erase(path.substr(0, dot));
}

/// "mixed", "courant 0.5"
std::string named_value(const std::string& key, const std::string& value) {
    const bool is_word = !value.empty() && std::isalpha(static_cast<unsigned char>(value[0])) != 0;
    const bool tells_itself =
        is_word && !value_of_word<Switch>(value) && value != "none" && value != "true" && value != "false";
    if (tells_itself) return value;
    std::string name = key.substr(key.find_last_of('.') + 1);
    std::replace(name.begin(), name.end(), '_', ' ');
    return name + " " + value;
}

}  // namespace

std::string value_in_scene(const Scene& scene, const std::string& key) {
    const toml::table table = toml::parse(scene.source);
    if (const toml::node* node = table.at_path(key).node()) return text_of(*node);
    constexpr std::string_view method = "method.";
    return key.starts_with(method) ? from_method(scene.method, key.substr(method.size())) : "";
}

Axis parse_axis(const std::string& text, const Scene& scene) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) fail(scene, text, "found no key, expected key.path=V1,V2,...");
    Axis axis{text.substr(0, equals), {}};
    for (const std::string& value : split(text.substr(equals + 1))) {
        if (value.empty()) fail(scene, text, "found an empty value, expected key.path=V1,V2,...");
        const std::string resolved = resolve(value, axis.key, text, scene);
        for (const std::string& earlier : axis.values)
            if (is_same_value(earlier, resolved)) fail(scene, text, fmt::format("found {} twice", value));
        axis.values.push_back(resolved);
    }
    return axis;
}

std::vector<std::vector<std::string>> combinations(const std::vector<Axis>& axes) {
    std::vector<std::vector<std::string>> all{{}};
    for (const Axis& axis : axes) {
        std::vector<std::vector<std::string>> longer;
        for (const auto& start : all)
            for (const std::string& value : axis.values) {
                longer.push_back(start);
                longer.back().push_back(value);
            }
        all = std::move(longer);
    }
    return all;
}

std::string method_name(const std::vector<Axis>& axes, const std::vector<std::string>& values, const Scene& scene) {
    std::string name;
    for (std::size_t k = 0; k < axes.size(); ++k)
        if (axes[k].key != spacing_key_name) name += (name.empty() ? "" : ", ") + named_value(axes[k].key, values[k]);
    if (name.empty()) name = value_in_scene(scene, "method.preset") + ", " + text_of(scene.method.precision);
    return name;
}

std::vector<std::string> overrides_of(const std::vector<Axis>& axes, const std::vector<std::string>& values) {
    std::vector<std::string> overrides;
    for (std::size_t k = 0; k < axes.size(); ++k) overrides.push_back(axes[k].key + "=" + values[k]);
    return overrides;
}

bool is_same_value(const std::string& a, const std::string& b) {
    const auto bare = [](const std::string& text) {
        const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
        return quoted ? text.substr(1, text.size() - 2) : text;
    };
    const std::optional<double> x = number_in(a), y = number_in(b);
    return x && y ? *x == *y : bare(a) == bare(b);
}

std::string fingerprint(const Scene& scene, const std::vector<Axis>& axes) {
    toml::table table = toml::parse(scene.source);
    for (const char* key :
         {"title", "output.frame_interval", "output.probe_interval", "probes", "reference", spacing_key_name})
        erase(table, key);
    for (const Axis& axis : axes) erase(table, axis.key);
    std::ostringstream text;
    text << toml::toml_formatter(table);
    return text_hash(text.str());
}

}  // namespace sluice
