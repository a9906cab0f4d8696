// Small scenes on which the conservation laws and limits of the whole scheme are tested.
#pragma once

#include <string>

#include "engine/simulation.hpp"
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
