#include <fmt/format.h>

#include "engine/command/completions.hpp"

namespace sluice {
namespace {

/// For a text within single quotes.
std::string in_zsh_quotes(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return safe;
}

/// For a part of a specification, where these have a meaning.
std::string part(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
        safe += c;
    }
    return in_zsh_quotes(safe);
}

std::string zsh_action(const CommandOption& option) {
    switch (option.completion) {
        case Completion::nothing:
            return " ";
        case Completion::files:
            return option.extension.empty() ? "_files" : fmt::format("_files -g \"*.{}\"", option.extension);
        case Completion::folders:
            return "_files -/";
        case Completion::words:
            break;
    }
    std::string words;
    for (const std::string& word : option.words) words += (words.empty() ? "" : " ") + part(word);
    return fmt::format("({})", words);
}

/// "'--output[what]:DIR:_files -/'" for each name.
std::string option_specs(const CommandOption& option) {
    std::string specs;
    for (const std::string& name : option.names) {
        std::string spec = fmt::format("{}{}[{}]", option.repeated ? "*" : "", name, part(option.what));
        if (!option.value.empty())
            spec += fmt::format("{}:{}:{}", option.value_optional ? ":" : "", part(option.value), zsh_action(option));
        specs += fmt::format(" \\\n        '{}'", spec);
    }
    return specs;
}

/// A function for each command, which calls those of the commands in it.
std::string function_of(const CommandNode& node, const std::string& name) {
    std::string text, specs;
    for (const CommandNode& command : node.commands) text += function_of(command, name + "_" + command.name);
    for (const CommandOption& option : node.options) specs += option_specs(option);
    int place = 1;
    for (const CommandOption& argument : node.arguments)
        specs += fmt::format(" \\\n        '{}:{}:{}'", place++, part(argument.value), zsh_action(argument));
    text += fmt::format("{}() {{\n", name);
    if (node.commands.empty()) return text + fmt::format("    _arguments -s{}\n}}\n", specs);
    text += "    local curcontext=$curcontext state line\n    local -a commands\n    commands=(\n";
    for (const CommandNode& command : node.commands)
        text += fmt::format("        '{}:{}'\n", command.name, part(command.what));
    text += fmt::format("    )\n    _arguments -C{} \\\n        '1: :->command' \\\n        '*:: :->rest'\n", specs);
    text += "    case $state in\n        command) _describe command commands ;;\n        rest)\n";
    text += "            case $words[1] in\n";
    for (const CommandNode& command : node.commands)
        text += fmt::format("                {0}) {1}_{0} ;;\n", command.name, name);
    return text + "            esac ;;\n    esac\n}\n";
}

}  // namespace

std::string zsh_completion(const CommandNode& program) {
    return "#compdef sluice\n# Completion of sluice's command line, printed by `sluice completion zsh`.\n" +
           function_of(program, "_sluice") +
           // Read by its name from a folder of functions, or as a script by `source`.
           "if [[ $funcstack[1] == _sluice ]]; then _sluice \"$@\"; else compdef _sluice sluice; fi\n";
}

}  // namespace sluice
