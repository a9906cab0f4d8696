#include <fmt/format.h>

#include "engine/command/completions.hpp"

namespace sluice {
namespace {

/// visit(path, node) for a command and those in it; `path` is what was typed: "sluice help scene".
template <class Visit>
void for_each_command(const CommandNode& node, const std::string& path, Visit visit) {
    visit(path, node);
    for (const CommandNode& command : node.commands) for_each_command(command, path + " " + command.name, visit);
}

/// What to do for a value.
std::string action(const CommandOption& option) {
    switch (option.completion) {
        case Completion::nothing:
            return ":";
        case Completion::files:
            return fmt::format("_sluice_files '{}'", option.extension);
        case Completion::folders:
            return "_sluice_folders";
        case Completion::words:
            break;
    }
    return fmt::format("_sluice_words '{}'", fmt::join(option.words, " "));
}

/// A pattern of `case` for each name of an option behind a path.
std::string patterns(const std::string& path, const CommandOption& option) {
    std::string text;
    for (const std::string& name : option.names)
        text += fmt::format("{}\"{} {}\"", text.empty() ? "" : " | ", path, name);
    return text;
}

std::string option_names(const CommandNode& node) {
    std::string names;
    for (const CommandOption& option : node.options)
        for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
    return names;
}

/// What may stand where no option does: commands, or arguments by their place.
std::string argument_action(const CommandNode& node) {
    if (!node.commands.empty()) {
        std::string names;
        for (const CommandNode& command : node.commands) names += (names.empty() ? "" : " ") + command.name;
        return fmt::format("_sluice_words '{}'", names);
    }
    return node.arguments.empty() ? ":" : action(node.arguments.front());
}

constexpr const char* head = R"(# Completion of sluice's command line, printed by `sluice completion bash`.
_sluice_words() {
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur")
    # A key goes on with its value.
    if [[ ${COMPREPLY[0]} == *= ]]; then compopt -o nospace 2>/dev/null; fi
}
_sluice_folders() {
    mapfile -t COMPREPLY < <(compgen -d -- "$cur")
    compopt -o filenames 2>/dev/null
}
_sluice_files() {
    mapfile -t COMPREPLY < <(compgen -d -- "$cur"; if [[ $1 ]]; then compgen -f -X "!*.$1" -- "$cur"; else compgen -f -- "$cur"; fi)
    compopt -o filenames 2>/dev/null
}
_sluice() {
    local cur=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} path=sluice i
    COMPREPLY=()
)";

}  // namespace

std::string bash_completion(const CommandNode& program) {
    std::string commands, values, names, arguments;
    for_each_command(program, program.name, [&](const std::string& path, const CommandNode& node) {
        if (&node != &program) commands += fmt::format("{}\"{}\"", commands.empty() ? "" : " | ", path);
        for (const CommandOption& option : node.options)
            if (!option.value.empty() && !option.value_optional)
                values += fmt::format("        {}) {}; return ;;\n", patterns(path, option), action(option));
        names += fmt::format("            \"{}\") _sluice_words '{}' ;;\n", path, option_names(node));
        arguments += fmt::format("        \"{}\") {} ;;\n", path, argument_action(node));
    });
    return std::string(head) +
           "    for ((i = 1; i < COMP_CWORD; ++i)); do\n        case \"$path ${COMP_WORDS[i]}\" in\n" +
           fmt::format("            {}) path+=\" ${{COMP_WORDS[i]}}\" ;;\n        esac\n    done\n", commands) +
           "    case \"$path $previous\" in\n" + values + "    esac\n" +
           "    if [[ $cur == -* ]]; then\n        case $path in\n" + names +
           "        esac\n        return\n    fi\n    case $path in\n" + arguments +
           "    esac\n}\ncomplete -F _sluice sluice\n";
}

}  // namespace sluice
