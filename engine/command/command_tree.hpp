// The program's commands and options as data, read from its own definitions: what completions and the manual are
// printed from.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sluice {

/// What a shell offers for a value.
enum class Completion { nothing, files, folders, words };

struct CommandOption {
    std::vector<std::string> names;  ///< "-o", "--output"; empty for an argument without one
    std::string value;               ///< "DIR"; empty for a switch
    std::string what;
    bool required = false;
    bool value_optional = false;
    bool repeated = false;
    Completion completion = Completion::nothing;
    std::string extension;           ///< of files: "toml"; empty = any
    std::vector<std::string> words;  ///< to choose from
};

struct CommandNode {
    std::string name;
    std::string what;
    std::string footer;
    std::vector<CommandOption> options;    ///< "--…"
    std::vector<CommandOption> arguments;  ///< by their place
    std::vector<CommandNode> commands;
};

CommandNode command_tree(const CLI::App& program);

}  // namespace sluice
