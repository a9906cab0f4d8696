// Water that hits a free elastic block, with nothing else around: what is lost on one side must turn up on the other.
#pragma once

#include "tests/engine/physics_scenes.hpp"

namespace sluice::collisions {

inline const std::string reference_model = "materials.rubber.model=st-venant-kirchhoff";

/// No velocity filter, whose normalisation does not conserve momentum, and no dissipation.
inline const std::string plain_method = R"toml(
[method.fluid]
velocity_filter = 1.0
[method.solid]
artificial_viscosity = 0.0
artificial_stress = 0.0
)toml";

/// In 2D, the water faster than the block by (1, 0.1) m/s and both with a velocity of their own.
inline std::string flat(double u = 0, double v = 0) {
    const auto number = [](double x) { return std::to_string(x); };
    return preamble(0.002) + plain_method + R"toml(
[bodies.water]
material = "water"
shape = { box = { min = [-0.04, -0.02], max = [-0.001, 0.02] } }
velocity = [)toml" +
           number(1 + u) + ", " + number(0.1 + v) + R"toml(]
[bodies.target]
material = "rubber"
shape = { box = { min = [0.0, -0.014], max = [0.012, 0.016] } }
velocity = [)toml" +
           number(u) + ", " + number(v) + "]\n";
}

/// In 3D.
inline std::string solid() {
    return "dimension = 3\n" + preamble(0.004) + plain_method + R"toml(
[bodies.water]
material = "water"
shape = { box = { min = [-0.032, -0.016, -0.016], max = [-0.002, 0.016, 0.016] } }
velocity = [1.0, 0.1, -0.2]
[bodies.target]
material = "rubber"
shape = { box = { min = [0.0, -0.012, -0.012], max = [0.016, 0.012, 0.012] } }
)toml";
}

/// Solid's particles as moving boundary, velocities of both media at the same time.
inline std::vector<std::string> coupled(std::vector<std::string> more = {}) {
    more.insert(more.end(), {reference_model, "method.coupling=moving-boundary", "method.integrator=kick-drift-kick"});
    return more;
}

}  // namespace sluice::collisions
