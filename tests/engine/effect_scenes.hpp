// For every effect a small scene, and what turns the effect on and off in it.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/rules/effects.hpp"
#include "tests/engine/physics_scenes.hpp"

namespace sluice::effect_scenes {

inline const std::string water = water_box("0.0, 0.0", "0.02, 0.02"), block = rubber_box("0.02, 0.0", "0.03, 0.02");
inline const std::string clamped_block = block + "clamp = { box = { min = [0.02, 0.01], max = [0.03, 0.02] } }\n";
inline const std::string second_water = R"toml(
[bodies.more]
material = "water"
shape = { box = { min = [0.0, 0.02], max = [0.02, 0.04] } }
spacing_ratio = 2.0
)toml";
inline const std::string oil = R"toml(
[materials.oil]
kind = "fluid"
density = 900.0
sound_speed = 30.0
[bodies.oil]
material = "oil"
shape = { box = { min = [0.0, 0.02], max = [0.02, 0.04] } }
)toml";
inline const std::string second_solid = R"toml(
[materials.metal]
kind = "solid"
density = 2700.0
youngs_modulus = 2e7
poisson_ratio = 0.3
[bodies.metal]
material = "metal"
shape = { box = { min = [0.02, 0.02], max = [0.03, 0.04] } }
)toml";
inline const std::string fixed = R"toml(
[walls.back]
kind = "fixed"
shape = { box = { min = [-0.008, 0.0], max = [0.0, 0.02] } }
)toml";
inline const std::string moving = fixed + "motion = { displacement = [\"0.1*t\", \"0\"] }\n";
inline const std::string periodic = "[domain]\nperiodic = { y = [0.0, 0.02] }\n";
inline const std::string viscous = "materials.water.viscosity=0.001";
inline const std::string total_lagrangian = "materials.rubber.model=neo-hookean";

/// Materials and method of the paper, then bodies and walls. Gravity and the driving acceleration come by overrides.
inline std::string scene(const std::string& content) { return preamble(0.002) + content; }

/// `on` and `off` are content and overrides of two scenes that differ in what calls for the effect.
struct Case {
    struct Side {
        std::string content;
        std::vector<std::string> overrides;
        Scene load() const { return scene_text::load(scene(content), overrides); }
    };
    Effect effect;
    Side on, off;
};

/// A scene of the same content with a key at one value or another.
inline Case by_key(Effect e, const std::string& content, const std::string& key, const std::string& on,
                   const std::string& off, const std::vector<std::string>& both = {}) {
    Case c{e, {content, both}, {content, both}};
    c.on.overrides.push_back(key + "=" + on);
    c.off.overrides.push_back(key + "=" + off);
    return c;
}
inline Case by_content(Effect e, const std::string& on, const std::string& off) { return {e, {on, {}}, {off, {}}}; }

inline std::vector<Case> cases() {
    const std::string both = water + block;
    const std::string f = "method.fluid.", s = "method.solid.";
    return {
        by_content(Effect::fluid_pressure, water, block),
        by_key(Effect::artificial_viscosity, water, f + "artificial_viscosity", "0.1", "0"),
        by_key(Effect::laminar_viscosity, water, "materials.water.viscosity", "0.001", "0"),
        by_key(Effect::acoustic_damping, water, f + "acoustic_damping", "0.5", "0"),
        by_key(Effect::density_diffusion, water, f + "density_diffusion", "fourtakas", "none"),
        by_key(Effect::excess_density, water, f + "density_diffusion", "fourtakas", "molteni-colagrossi",
               {"gravity=[0.0, -9.81]"}),
        by_key(Effect::density_gradient, water, f + "density_diffusion", "antuono", "fourtakas"),
        by_key(Effect::velocity_filter, water, f + "velocity_filter", "0.9", "1"),
        by_key(Effect::particle_shifting, water, f + "particle_shifting", "2", "0"),
        by_key(Effect::solid_stress, block, "materials.rubber.model", "hypoelastic", "neo-hookean"),
        by_key(Effect::total_lagrangian, block, "materials.rubber.model", "st-venant-kirchhoff", "hypoelastic"),
        by_key(Effect::hourglass_control, block, s + "hourglass_control", "0.1", "0", {total_lagrangian}),
        by_key(Effect::solid_viscosity, block, s + "artificial_viscosity", "1", "0"),
        by_key(Effect::artificial_stress, block, s + "artificial_stress", "0.3", "0"),
        by_key(Effect::solid_filter, block, s + "velocity_filter", "0.99", "1"),
        by_content(Effect::several_fluids, water + oil, water),
        by_content(Effect::several_solids, block + second_solid, block),
        {Effect::contact, {block + mirror_floor, {total_lagrangian}}, {block, {total_lagrangian}}},
        by_key(Effect::interface_force, both, "method.coupling", "interface-force", "moving-boundary"),
        by_key(Effect::moving_boundary, both, "method.coupling", "moving-boundary", "interface-force"),
        by_content(Effect::mirror_wall, water + mirror_floor, water),
        by_content(Effect::fixed_wall, water + fixed, water),
        {Effect::no_slip_wall, {water + fixed + "condition = \"no-slip\"\n", {viscous}}, {water + fixed, {viscous}}},
        by_key(Effect::no_slip_solid, both, "materials.water.viscosity", "0.001", "0",
               {"method.coupling=moving-boundary"}),
        by_content(Effect::moving_wall, water + moving, water + fixed),
        by_content(Effect::periodic_box, periodic + water, water),
        by_content(Effect::clamp, clamped_block, block),
        {Effect::clamp_extension, {clamped_block, {total_lagrangian}}, {clamped_block, {}}},
        by_key(Effect::gravity, water, "gravity", "[0.0, -9.81]", "[0.0, 0.0]"),
        {Effect::driven_acceleration, {water, {"acceleration=['sin(t)', 0.0]"}}, {water, {}}},
        by_content(Effect::variable_resolution, water + second_water, water),
        by_key(Effect::adaptive_step, water, "method.step_size", "adaptive", "fixed"),
        by_key(Effect::solid_substeps, both, "method.time_stepping", "multi-rate", "single-rate"),
        by_key(Effect::steady_load, both, "method.time_stepping", "multi-rate", "single-rate", {total_lagrangian}),
    };
}

}  // namespace sluice::effect_scenes
