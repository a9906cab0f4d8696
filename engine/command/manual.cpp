#include "engine/command/manual.hpp"

#include <fmt/format.h>

namespace sluice {
namespace {

/// Text as roff shows it: hyphens that can be copied, no line taken for a request.
std::string roff(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        const bool starts_line = safe.empty() || safe.back() == '\n';
        if (starts_line && (c == '.' || c == '\'')) safe += "\\&";
        if (c == '\\')
            safe += "\\e";
        else if (c == '-')
            safe += "\\-";
        else
            safe += c;
    }
    return safe;
}

std::string example_block(std::string_view text) {
    std::string body = roff(text);
    while (!body.empty() && body.back() == '\n') body.pop_back();
    return fmt::format(".PP\n.nf\n{}\n.fi\n", body);
}

std::string value_of(const CommandOption& option) {
    if (option.value.empty()) return "";
    const std::string value = fmt::format("\\fI{}\\fR", roff(option.value));
    return option.value_optional ? fmt::format(" [{}]", value) : " " + value;
}

std::string option_entry(const CommandOption& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
    const std::string words = option.completion == Completion::words && option.value == "WORD"
                                  ? fmt::format("; one of {}", fmt::join(option.words, ", "))
                                  : "";
    return fmt::format(".TP\n{}{}\n{}{}.\n", names, value_of(option), roff(option.what), roff(words));
}

/// "sluice run [options] [SCENE]"
std::string synopsis(const CommandNode& node, const std::string& path) {
    std::string text = fmt::format("\\fB{}\\fR", roff(path));
    if (!node.options.empty()) text += " [\\fIoptions\\fR]";
    for (const CommandOption& argument : node.arguments)
        text += argument.required ? fmt::format(" \\fI{}\\fR", argument.value)
                                  : fmt::format(" [\\fI{}\\fR]", argument.value);
    return node.commands.empty() ? text : fmt::format("\\fB{}\\fR \\fICOMMAND\\fR", roff(path));
}

std::string command_section(const CommandNode& node, const std::string& path, const std::string& inherited) {
    std::string text;
    if (node.commands.empty()) {
        text += fmt::format(".SS {}\n{}.\n", synopsis(node, path), roff(node.what));
        for (const CommandOption& argument : node.arguments)
            text += fmt::format(".TP\n\\fI{}\\fR\n{}.\n", roff(argument.value), roff(argument.what));
        for (const CommandOption& option : node.options)
            if (option.names.back() != "--help") text += option_entry(option);
        if (!node.footer.empty() && node.footer != inherited) text += example_block(node.footer);
    }
    for (const CommandNode& command : node.commands)
        text += command_section(command, path + " " + command.name, inherited);
    return text;
}

}  // namespace

std::string manual_page(const CommandNode& program, std::string_view version) {
    std::string text = fmt::format(".TH SLUICE 1 \"\" \"sluice {}\" \"User Commands\"\n", version);
    text += fmt::format(".SH NAME\nsluice \\- {}\n", roff(program.what));
    text += ".SH SYNOPSIS\n";
    for (const CommandNode& command : program.commands)
        text += fmt::format("{}\n.br\n", synopsis(command, program.name + " " + command.name));
    text +=
        ".SH DESCRIPTION\nA scene is a text in TOML; its content decides what is simulated. \\fBsluice new\\fR writes "
        "one "
        "to\nstart from, \\fBsluice check\\fR says what a run would do, \\fBsluice run\\fR does it, \\fBsluice "
        "view\\fR "
        "and\n\\fBsluice render\\fR show it. \\fBsluice help scene\\fR lists all that a scene may say. Every command "
        "has\n"
        "\\fB\\-\\-help\\fR.\n.SH COMMANDS\n";
    text += command_section(program, program.name, program.footer);
    text += ".SH EXAMPLES, FILES, EXIT STATUS\n" + example_block(program.footer);
    return text;
}

}  // namespace sluice
