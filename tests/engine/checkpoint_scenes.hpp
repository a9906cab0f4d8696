// Scenes in which, together, everything that a run must remember is in use. All of them move fast enough to list
// neighbours anew within some steps.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"
#include "tests/engine/contact_scenes.hpp"
#include "tests/engine/test_scenes.hpp"

namespace sluice::checkpoint_scenes {

/// Water that falls past a moving wall in a periodic box, with friction at the wall.
inline const std::string channel = R"toml(title = "Channel"
gravity = [2.0, -9.81]
acceleration = ["0.5*sin(40*t)", "0"]
[domain]
periodic = { x = [0.0, 0.04] }
[method]
preset = "modern"
spacing = 0.002
[materials.water]
kind = "fluid"
density = 1000.0
sound_speed = 20.0
viscosity = 0.01
[bodies.water]
material = "water"
shape = { box = { min = [0.0, 0.0], max = [0.04, 0.02] } }
velocity = ["1.5", "0.2*sin(100*x)"]
[walls.floor]
kind = "fixed"
shape = { box = { min = [0.0, -0.012], max = [0.04, 0.0] } }
condition = "no-slip"
motion = { displacement = ["0.3*t", "0.002*sin(50*t)"] }
[probes.energy]
kind = "energy"
[output]
end = 0.02
frame_interval = 0.005
probe_interval = 0.001
checkpoint_interval = 0.003
)toml";

struct Case {
    std::string name;
    Scene scene;
};

inline std::vector<Case> cases() {
    const std::string gate = test_scene("small_gate.toml"), tank = test_scene("still_water_3d.toml");
    const std::string shaken = "bodies.tank.velocity=['1.5*sin(100*y)', '-0.8']";
    const std::vector<std::string> modern{"method.preset=modern", "method.expected_speed=2", shaken};
    const auto with = [&](std::vector<std::string> more, const std::vector<std::string>& all) {
        more.insert(more.end(), all.begin(), all.end());
        return more;
    };
    using namespace contact_scenes;
    const std::string discs = rubber(0.002) + body("left", disc(-0.0095, 0, 0.008), "[\"3\", \"0.5\"]") +
                              body("right", disc(0.0095, 0.003, 0.008), "[\"-3\", \"0\"]") +
                              "[walls.floor]\nkind = \"mirror\"\npoint = [0.0, -0.0085]\nnormal = [0.0, 1.0]\n";
    return {
        {"paper: hypoelastic, staggered Euler, interface force", load_scene(gate, {shaken})},
        {"paper, several steps of the solid in one", load_scene(gate, {shaken, "method.time_stepping=multi-rate"})},
        {"modern: total Lagrangian, adaptive steps, moving boundary, shifting", load_scene(gate, modern)},
        {"modern, a light gate", load_scene(gate, with({"materials.rubber.density=200"}, modern))},
        {"modern, interface force", load_scene(gate, with({"method.coupling=interface-force"}, modern))},
        {"modern, hypoelastic", load_scene(gate, with({"materials.rubber.model=hypoelastic"}, modern))},
        {"modern, gradients of density", load_scene(gate, with({"method.fluid.density_diffusion=antuono"}, modern))},
        {"periodic box, moving wall, friction", scene_text::load(channel)},
        {"3D", load_scene(tank, {"bodies.tank.velocity=['1.5', '0', '0.5*sin(50*y)']"})},
        {"3D, modern",
         load_scene(tank, {"method.preset=modern", "bodies.tank.velocity=['1.5', '0', '0.5*sin(50*y)']"})},
        {"contact", scene_text::load(discs)},
    };
}

}  // namespace sluice::checkpoint_scenes
