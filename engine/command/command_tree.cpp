#include "engine/command/command_tree.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "engine/scene/effects/effect_table.hpp"
#include "engine/scene/help/scene_help.hpp"
#include "engine/scene/table/scene_keys.hpp"
#include "engine/scene/templates/scene_templates.hpp"

namespace sluice {
namespace {

/// "TEXT:{mp4,webm,none}" → the words.
std::vector<std::string> choices_in(const std::string& type) {
    std::vector<std::string> words;
    const std::size_t open = type.find('{'), close = type.find('}');
    if (open == std::string::npos || close == std::string::npos) return words;
    for (std::size_t start = open + 1; start < close;) {
        const std::size_t end = std::min(type.find(',', start), close);
        words.push_back(type.substr(start, end - start));
        start = end + 1;
    }
    return words;
}

/// Keys that --set and --vary may change in any scene; names of the user's are not known here.
std::vector<std::string> settable_keys() {
    std::vector<std::string> keys;
    for (const SceneKey& key : scene_keys()) {
        const bool plain = key.path.find('*') == std::string_view::npos && !key.path.starts_with("SHAPE");
        if (plain && key.value.type != KeyType::table && key.value.type != KeyType::names)
            keys.push_back(std::string(key.path) + "=");
    }
    return keys;
}

std::vector<std::string> template_names() {
    std::vector<std::string> names;
    for (const SceneTemplate& scene : scene_templates()) names.emplace_back(scene.name);
    return names;
}

std::vector<std::string> help_keys(const std::string& topic) {
    std::vector<std::string> keys;
    if (topic == "effects")
        for (const EffectInfo& info : effect_table) keys.emplace_back(info.key);
    if (topic == "scene")
        for (const SceneKey& key : scene_keys()) keys.push_back(shown_path(key));
    return keys;
}

/// By what the value is called.
void complete(CommandOption& option, const std::string& command) {
    const std::string& value = option.value;
    const auto is = [&](std::string_view text) { return value.starts_with(text); };
    if (option.words.empty() && is("TEMPLATE")) option.words = template_names();
    if (option.words.empty() && is("KEY")) option.words = value == "KEY" ? help_keys(command) : settable_keys();
    if (!option.words.empty()) {
        option.completion = Completion::words;
    } else if (is("DIR")) {
        option.completion = Completion::folders;
    } else if (is("SCENE") || is("FILE")) {
        option.completion = Completion::files;
        const std::size_t dot = value.find('.');
        option.extension = is("SCENE") ? "toml" : dot == std::string::npos ? "" : value.substr(dot + 1);
    }
}

CommandOption option_of(const CLI::Option& option, const std::string& command) {
    CommandOption made;
    for (const std::string& name : option.get_snames()) made.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) made.names.push_back("--" + name);
    made.what = option.get_description();
    made.required = option.get_required();
    // A flag that takes a value has a type of its own; what others are called is "TEXT" or "BOOLEAN".
    const std::string type = option.get_type_name();
    made.words = choices_in(type);
    const bool takes_value = option.get_items_expected_max() > 0;
    made.value_optional = takes_value ? option.get_items_expected_min() == 0 : !type.empty() && type != "BOOLEAN";
    if (made.names.empty())
        made.value = option.get_name(true);
    else if (takes_value || made.value_optional)
        made.value = made.words.empty() ? type.substr(0, type.find(':')) : "WORD";
    made.repeated = option.get_items_expected_max() >= CLI::detail::expected_max_vector_size;
    complete(made, command);
    return made;
}

CommandNode node_of(const CLI::App& app) {
    CommandNode node{app.get_name(), app.get_description(), app.get_footer(), {}, {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        CommandOption made = option_of(*option, node.name);
        (made.names.empty() ? node.arguments : node.options).push_back(std::move(made));
    }
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        node.commands.push_back(node_of(*command));
    return node;
}

}  // namespace

CommandNode command_tree(const CLI::App& program) { return node_of(program); }

}  // namespace sluice
