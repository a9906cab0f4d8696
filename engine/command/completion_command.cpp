#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "engine/command/commands.hpp"
#include "engine/command/completions.hpp"

namespace sluice {
namespace {

constexpr const char* completion_footer =
    R"(`cmake --install` puts them where shells look. Without it:

  bash    sluice completion bash > ~/.local/share/bash-completion/completions/sluice
  zsh     sluice completion zsh > ~/.zfunc/_sluice      (fpath+=~/.zfunc before compinit in ~/.zshrc)
  fish    sluice completion fish > ~/.config/fish/completions/sluice.fish
)";

}  // namespace

void add_completion_command(CLI::App& program, Deed& chosen) {
    CLI::App& command = *program.add_subcommand("completion", "Print what lets a shell complete sluice's command line");
    const auto shell = std::make_shared<std::string>();
    command.add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command.footer(completion_footer);
    command.callback([shell, &program, &chosen] {
        chosen = [shell, &program] {
            const CommandNode tree = command_tree(program);
            print(*shell == "bash"  ? bash_completion(tree)
                  : *shell == "zsh" ? zsh_completion(tree)
                                    : fish_completion(tree));
            return ExitCode::done;
        };
    });
}

}  // namespace sluice
