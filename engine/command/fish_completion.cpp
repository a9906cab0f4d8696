#include <fmt/format.h>

#include "engine/command/completions.hpp"

namespace sluice {
namespace {

std::string in_quotes(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '\'' || c == '\\') safe += '\\';
        safe += c;
    }
    return "'" + safe + "'";
}

/// What is offered for a value; fish offers files by itself where they are not forbidden.
std::string offer(const CommandOption& option) {
    switch (option.completion) {
        case Completion::nothing:
            return " -f";
        case Completion::files:
            return option.extension.empty() ? ""
                                            : fmt::format(" -f -a '(__fish_complete_suffix .{})'", option.extension);
        case Completion::folders:
            return " -f -a '(__fish_complete_directories)'";
        case Completion::words:
            break;
    }
    return fmt::format(" -f -a {}", in_quotes(fmt::format("{}", fmt::join(option.words, " "))));
}

std::string names_of(const CommandOption& option) {
    std::string text;
    for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    return text;
}

/// `condition`: when this command is the one that is typed.
std::string lines_of(const CommandNode& node, const std::string& condition) {
    std::string own = condition, inner;
    for (const CommandNode& command : node.commands) inner += (inner.empty() ? "" : " ") + command.name;
    if (!inner.empty())
        own += fmt::format("{}not __fish_seen_subcommand_from {}", condition.empty() ? "" : "; and ", inner);
    const std::string line = fmt::format("complete -c sluice -n {}", in_quotes(own));
    std::string text;
    for (const CommandOption& option : node.options) {
        const bool takes_value = !option.value.empty() && !option.value_optional;
        text += fmt::format("{}{}{} -d {}\n", line, names_of(option), takes_value ? " -r" + offer(option) : "",
                            in_quotes(option.what));
    }
    for (const CommandOption& argument : node.arguments)
        text += fmt::format("{}{} -d {}\n", line, offer(argument), in_quotes(argument.what));
    for (const CommandNode& command : node.commands) {
        text += fmt::format("{} -f -a {} -d {}\n", line, command.name, in_quotes(command.what));
        text += lines_of(command, fmt::format("{}{}__fish_seen_subcommand_from {}", condition,
                                              condition.empty() ? "" : "; and ", command.name));
    }
    return text;
}

}  // namespace

std::string fish_completion(const CommandNode& program) {
    return "# Completion of sluice's command line, printed by `sluice completion fish`.\n" + lines_of(program, "");
}

}  // namespace sluice
