// Scenes written out as text by the tests, and the complaints they cause.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scene_text {

/// Every table of the schema; tests change one line of it at a time, and count on its line numbers.
inline const std::string gate = R"toml(title = "elastic gate"
gravity = [0.0, -9.81]
[constants]
kL = 1.875
[method]
preset = "paper"
spacing = 1e-3
courant = 0.5
[materials.water]
kind = "fluid"
density = 1000.0
sound_speed = 30
[materials.rubber]
kind = "solid"
density = 1100.0
youngs_modulus = 1.2e7
poisson_ratio = 0.4
[bodies.water]
material = "water"
shape = { box = { min = [-0.1, 0.0], max = [0.0, 0.14] } }
spacing_ratio = 2.0
hydrostatic_surface = 0.14
velocity = ["0", "0.01*sin(pi*x*kL)"]
[bodies.gate]
material = "rubber"
shape = { box = { min = [0.0, 0.0], max = [0.005, 0.08] } }
clamp = { box = { min = [0.0, 0.075], max = [0.005, 0.08] } }
[walls.bottom]
kind = "mirror"
point = [0.0, 0.0]
normal = [0.0, 2.0]
[walls.upper]
kind = "fixed"
shape = { box = { min = [0.0, 0.08], max = [0.005, 0.14] } }
spacing = 0.002
[probes.free_end]
kind = "displacement"
body = "gate"
at = [0.0025, 0.0]
[probes.level]
kind = "water_level"
at = -0.05
[probes.balance]
kind = "energy"
[output]
end = 0.4
frame_interval = 0.01
)toml";

/// A scene file that lives as long as the object; each process has its own.
class File {
  public:
    explicit File(const std::string& text) : path_("/tmp/sluice-scene-" + std::to_string(::getpid()) + ".toml") {
        std::ofstream(path_) << text;
    }
    ~File() { std::remove(path_.c_str()); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

inline sluice::Scene load(const std::string& text, const std::vector<std::string>& overrides = {}) {
    const File file(text);
    return sluice::load_scene(file.path(), overrides);
}

/// What `action` throws as SceneError, without the file's path: "12: method.spacing: found …"; empty if it throws
/// nothing.
template <class Action>
std::string error_of(Action action) {
    try {
        action();
    } catch (const sluice::SceneError& error) {
        const std::string text = error.what();
        const std::string suffix = ".toml:";
        const std::size_t end = text.find(suffix);
        return end == std::string::npos ? text : text.substr(end + suffix.size());
    }
    return "";
}

inline std::string load_error(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return error_of([&] { load(text, overrides); });
}

/// `text` with its only `from` replaced; a test that replaces nothing is wrong.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("no '" + from + "' in the scene");
    return text.replace(at, from.size(), to);
}

/// What the elastic gate's scene is answered with after one replacement.
inline std::string gate_error(const std::string& from, const std::string& to) {
    return load_error(with(gate, from, to));
}

}  // namespace scene_text
