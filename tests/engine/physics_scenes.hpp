// Small scenes on which the conservation laws and limits of the whole scheme are tested.
#pragma once

#include <string>

#include "engine/simulation/simulation.hpp"
#include "tests/engine/scene_text.hpp"

namespace sluice {

/// Materials and method of the elastic gate, at a spacing [m]; velocity filter and viscosities as in the paper.
inline std::string preamble(double spacing) {
    return "title = \"test\"\n[method]\npreset = \"paper\"\nspacing = " + std::to_string(spacing) + R"toml(
expected_speed = 1.0
[materials.water]
kind = "fluid"
density = 1000.0
sound_speed = 30.0
[materials.rubber]
kind = "solid"
density = 1100.0
youngs_modulus = 1.2e6
poisson_ratio = 0.4
[output]
end = 1.0
)toml";
}

inline const std::string with_gravity = "gravity = [0.0, -9.81]\n";  ///< stands before the preamble

/// A body that fills a box. Corners are written as in TOML, "0.0, 0.0".
inline std::string box_body(const std::string& name, const std::string& material, const std::string& from,
                            const std::string& to) {
    return "[bodies." + name + "]\nmaterial = \"" + material + "\"\nshape = { box = { min = [" + from + "], max = [" +
           to + "] } }\n";
}
inline std::string water_box(const std::string& from, const std::string& to) {
    return box_body("water", "water", from, to);
}
inline std::string rubber_box(const std::string& from, const std::string& to) {
    return box_body("block", "rubber", from, to);
}

inline const std::string mirror_floor = R"toml(
[walls.floor]
kind = "mirror"
point = [0.0, 0.0]
normal = [0.0, 1.0]
)toml";
/// A mirror wall to the left of all.
inline std::string mirror_back(const std::string& x) {
    return "[walls.back]\nkind = \"mirror\"\npoint = [" + x + ", 0.0]\nnormal = [1.0, 0.0]\n";
}
/// Mirror walls at x = 0 and x = `width`.
inline std::string mirror_sides(const std::string& width) {
    return "[walls.left]\nkind = \"mirror\"\npoint = [0.0, 0.0]\nnormal = [1.0, 0.0]\n"
           "[walls.right]\nkind = \"mirror\"\npoint = [" +
           width + ", 0.0]\nnormal = [-1.0, 0.0]\n";
}

/// Water 0.06 m deep, from x = `back` on, that leans on a gate whose upper end is clamped.
inline std::string water_at_gate(const std::string& back) {
    return water_box(back + ", 0.0", "0.0, 0.06") + "hydrostatic_surface = 0.06\n" +
           box_body("gate", "rubber", "0.0, 0.0", "0.01, 0.06") +
           "clamp = { box = { min = [0.0, 0.05], max = [0.01, 0.06] } }\n";
}
/// The same in a basin of mirror walls.
inline std::string gate_in_basin() {
    return with_gravity + preamble(0.0025) + water_at_gate("-0.05") + mirror_floor + mirror_back("-0.05");
}

/// A free elastic body of some shape, hit by a moving block of water; no walls, no gravity, no velocity filter (whose
/// normalisation, eq. 16, differs between the partners of a pair and so does not conserve momentum).
inline std::string collision(const std::string& body_shape) {
    return preamble(0.002) + "[method.fluid]\nvelocity_filter = 1.0\n" + water_box("-0.04, -0.02", "-0.001, 0.02") +
           "velocity = [1.0, 0.1]\n[bodies.target]\nmaterial = \"rubber\"\nshape = " + body_shape;
}

template <int Dim>
void advance(Simulation<Dim>& simulation, int steps) {
    for (int s = 0; s < steps; ++s) simulation.step();
}

inline double kinetic_energy_per_mass(const Simulation<2>& simulation) {
    double mass = 0;
    for (std::size_t i = 0; i < simulation.fluid().owned; ++i) mass += simulation.fluid().mass[i];
    for (std::size_t i = 0; i < simulation.solid().owned; ++i) mass += simulation.solid().mass[i];
    return simulation.energy().kinetic / mass;
}

}  // namespace sluice
