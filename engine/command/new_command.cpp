#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/command/commands.hpp"
#include "engine/files/atomic_file.hpp"
#include "engine/scene/help/scene_schema.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/table/suggestion.hpp"
#include "engine/scene/templates/scene_templates.hpp"

namespace sluice {
namespace {

struct NewArguments {
    std::string name, output;
    bool force = false;
};

constexpr const char* new_footer =
    R"(  sluice new                                     lists the templates
  sluice new dam-break                           writes dam-break.toml
  sluice new dam-break -o flood.toml             writes flood.toml; -o - prints it

Beside the scene it writes sluice.schema.json, unless it is there: editors that know TOML schemas (taplo, "Even
Better TOML") complete keys with it, explain them, and mark mistakes.
)";

const SceneTemplate& find_template(const std::string& name) {
    std::vector<std::string> names;
    for (const SceneTemplate& scene : scene_templates()) {
        if (scene.name == name) return scene;
        names.emplace_back(scene.name);
    }
    throw SceneError(fmt::format("new: found \"{}\", expected {}{}", name, one_of(names), did_you_mean(name, names)));
}

ExitCode write_scene(const NewArguments& arguments) {
    if (arguments.name.empty()) {
        print(template_list() + "\n`sluice new NAME` writes one of them to NAME.toml\n");
        return ExitCode::done;
    }
    const SceneTemplate& scene = find_template(arguments.name);
    if (arguments.output == "-") {
        print(std::string(scene.text));
        return ExitCode::done;
    }
    const std::filesystem::path file = arguments.output.empty() ? arguments.name + ".toml" : arguments.output;
    if (std::filesystem::exists(file) && !arguments.force)
        throw SceneError(
            fmt::format("{}: is there already; -o writes to another file, --force overwrites it", file.string()));
    const std::filesystem::path schema = file.parent_path() / schema_file;
    write_atomically(file, scene.text);
    if (!std::filesystem::exists(schema) || arguments.force) write_atomically(schema, scene_schema());
    print(fmt::format("{0}: {1}\n\n  sluice check {0} --draw\n  sluice run {0}\n", file.string(), scene.summary()));
    return ExitCode::done;
}

}  // namespace

void add_new_command(CLI::App& program, Deed& chosen) {
    CLI::App& command = *program.add_subcommand("new", "Write a scene to start from");
    const auto arguments = std::make_shared<NewArguments>();
    command.add_option("TEMPLATE", arguments->name, "Which one; without it they are listed");
    command.add_option("-o,--output", arguments->output, "The scene [TEMPLATE.toml]")->type_name("FILE.toml");
    command.add_flag("--force", arguments->force, "Overwrite files that are there");
    command.footer(new_footer);
    command.callback([arguments, &chosen] { chosen = [arguments] { return write_scene(*arguments); }; });
}

}  // namespace sluice
