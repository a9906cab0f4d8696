// What `run` and `check` have in common: a scene, and changes to it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sluice {

struct SceneOptions {
    std::string file;
    std::vector<std::string> overrides;  ///< key.path=value

    void add_to(CLI::App& command) {
        command.add_option("SCENE", file, "Scene file (TOML)")->required();
        // One value each: else `--set a=1 scene.toml` would take the scene for a second change.
        command
            .add_option("--set", overrides, "Change a value of the scene, e.g. method.spacing=0.002; may be repeated")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
    }
};

}  // namespace sluice
