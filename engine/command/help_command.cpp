#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <vector>

#include "engine/base/version.hpp"
#include "engine/command/commands.hpp"
#include "engine/command/manual.hpp"
#include "engine/command/topics.hpp"
#include "engine/scene/help/scene_help.hpp"
#include "engine/scene/help/scene_schema.hpp"
#include "engine/scene/rules/effect_help.hpp"
#include "engine/scene/table/suggestion.hpp"

namespace sluice {
namespace {

struct HelpArguments {
    std::string key;
    bool markdown = false;
};

ExitCode refuse(std::string_view topic, const std::string& key, const std::string& expected) {
    print_error(fmt::format("help {}: found \"{}\", expected {}", topic, key, expected));
    return ExitCode::bad_input;
}

ExitCode print_effect(const std::string& key) {
    if (const EffectInfo* effect = find_effect(key)) {
        print(effect_page(*effect));
        return ExitCode::done;
    }
    std::vector<std::string> keys;
    for (const EffectInfo& info : effect_table) keys.emplace_back(info.key);
    return refuse("effects", key, one_of(keys) + did_you_mean(key, keys));
}

void add_texts(CLI::App& command, Deed& chosen) {
    for (const Topic& topic : topics()) {
        CLI::App& help = *command.add_subcommand(std::string(topic.name), std::string(topic.title()));
        help.callback([topic, &chosen] {
            chosen = [topic] {
                print(topic.text);
                return ExitCode::done;
            };
        });
    }
}

ExitCode print_scene_keys(const std::string& key) {
    const std::vector<const SceneKey*> meant = meant_scene_keys(key);
    if (meant.empty())
        return refuse("scene", key,
                      "a key of scenes; `sluice help scene` lists them" + did_you_mean(key, scene_key_names()));
    for (const SceneKey* row : meant) print(scene_key_page(*row));
    return ExitCode::done;
}

/// What has a list, a page per key, and a document of all.
struct ReferencePage {
    const char* name;
    const char* what;
    const char* document;
    std::string (*list)();
    std::string (*markdown)();
    ExitCode (*page)(const std::string& key);
};

void add_reference(CLI::App& help, const ReferencePage& topic, Deed& chosen) {
    CLI::App& command = *help.add_subcommand(topic.name, topic.what);
    const auto arguments = std::make_shared<HelpArguments>();
    CLI::Option* key = command.add_option("KEY", arguments->key, "Only this one, with all that is known of it");
    command.add_flag("--markdown", arguments->markdown, fmt::format("Print {}", topic.document))->excludes(key);
    command.callback([arguments, topic, &chosen] {
        chosen = [arguments, topic] {
            if (!arguments->key.empty()) return topic.page(arguments->key);
            print(arguments->markdown ? topic.markdown() : topic.list());
            return ExitCode::done;
        };
    });
}

}  // namespace

void add_help_command(CLI::App& program, Deed& chosen) {
    CLI::App& command = *program.add_subcommand("help", "Explain what a scene can ask for, and what a run gives");
    command.require_subcommand(1);
    add_reference(command,
                  {"scene", "What a scene may say: keys, values, defaults", "engine/SCENE.md", scene_key_list,
                   scene_document, print_scene_keys},
                  chosen);
    add_reference(command,
                  {"effects", "What the effects are, and when they are on", "engine/EFFECTS.md", effect_list,
                   effects_document, print_effect},
                  chosen);
    CLI::App& manual = *command.add_subcommand("manual", "The manual page, as `man -l` reads it");
    manual.callback([&program, &chosen] {
        chosen = [&program] {
            print(manual_page(command_tree(program), program_version()));
            return ExitCode::done;
        };
    });
    CLI::App& schema = *command.add_subcommand("schema", "A JSON schema, with which editors complete and check scenes");
    schema.callback([&chosen] {
        chosen = [] {
            print(scene_schema());
            return ExitCode::done;
        };
    });
    add_texts(command, chosen);
}

}  // namespace sluice
