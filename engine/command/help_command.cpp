#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <vector>

#include "engine/command/commands.hpp"
#include "engine/command/topics.hpp"
#include "engine/effect_help.hpp"
#include "engine/effect_table.hpp"
#include "engine/scene/suggestion.hpp"

namespace sluice {
namespace {

struct HelpArguments {
    std::string key;
    bool markdown = false;
};

ExitCode print_page(const std::string& key) {
    std::vector<std::string> keys;
    for (const EffectRow& row : effect_table()) keys.emplace_back(row.info.key);
    const auto found = std::find(keys.begin(), keys.end(), key);
    if (found == keys.end()) {
        print_error(
            fmt::format("help effects: found \"{}\", expected {}{}", key, one_of(keys), did_you_mean(key, keys)));
        return ExitCode::bad_input;
    }
    print(effect_page(effect_table()[static_cast<std::size_t>(found - keys.begin())].info));
    return ExitCode::done;
}

void add_topics(CLI::App& command, Deed& chosen) {
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

}  // namespace

void add_help_command(CLI::App& program, Deed& chosen) {
    CLI::App& command = *program.add_subcommand("help", "Explain what a scene can ask for, and what a run gives");
    command.require_subcommand(1);
    CLI::App& effects = *command.add_subcommand("effects", "What the effects are, and when they are on");
    const auto arguments = std::make_shared<HelpArguments>();
    CLI::Option* key = effects.add_option("KEY", arguments->key, "Only this effect, with formula, source and fields");
    effects.add_flag("--markdown", arguments->markdown, "Print engine/EFFECTS.md")->excludes(key);
    effects.callback([arguments, &chosen] {
        chosen = [arguments] {
            if (!arguments->key.empty()) return print_page(arguments->key);
            print(arguments->markdown ? effects_document() : effect_list());
            return ExitCode::done;
        };
    });
    add_topics(command, chosen);
}

}  // namespace sluice
