#include "engine/effects.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sluice {
namespace {

/// What the rules look at.
struct SceneContent {
    bool fluid = false, solid = false, clamp = false, mirror = false, fixed = false, gravity = false;
    bool many_spacings = false;
    std::string fluids, solids, clamps, mirrors, fixed_walls;
};

void add_name(std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; }

SceneContent look_at(const Scene& scene) {
    SceneContent c;
    double smallest = 1e300, largest = 0;
    for (const Body& body : scene.bodies) {
        const bool is_fluid = scene.materials[body.material].kind == MaterialKind::fluid;
        (is_fluid ? c.fluid : c.solid) = true;
        add_name(is_fluid ? c.fluids : c.solids, body.name);
        if (body.clamp) c.clamp = true, add_name(c.clamps, body.name);
        smallest = std::min(smallest, body.spacing);
        largest = std::max(largest, body.spacing);
    }
    c.many_spacings = largest > smallest * (1 + 1e-9);
    for (const Wall& wall : scene.walls) {
        (wall.kind == WallKind::mirror ? c.mirror : c.fixed) = true;
        add_name(wall.kind == WallKind::mirror ? c.mirrors : c.fixed_walls, wall.name);
    }
    c.gravity = std::any_of(scene.gravity.begin(), scene.gravity.end(), [](double g) { return g != 0; });
    return c;
}

/// A rule's answer.
struct Decision {
    bool on;
    std::string why;
};

Decision needs_fluid(const SceneContent& c) {
    return c.fluid ? Decision{true, "fluid bodies: " + c.fluids} : Decision{false, "no fluid body"};
}
Decision needs_solid(const SceneContent& c) {
    return c.solid ? Decision{true, "solid bodies: " + c.solids} : Decision{false, "no solid body"};
}

/// On if its medium is there and its constant differs from the value at which the term vanishes.
Decision by_constant(const Decision& medium, std::string_view symbol, double value, double off_value) {
    if (!medium.on) return medium;
    return {value != off_value, fmt::format("{} = {}", symbol, value)};
}

using Rule = Decision (*)(const Scene&, const SceneContent&);

/// The one table of effects: name, source, rule. Its order is that of the enumeration.
struct Row {
    EffectInfo info;
    Rule rule;
};

const std::array<Row, effect_count> table{{
    {{Effect::fluid_pressure, "fluid: continuity, pressure, linear equation of state", "Antoci2007 eqs. 4, 8, 10"},
     [](const Scene&, const SceneContent& c) { return needs_fluid(c); }},
    {{Effect::fluid_viscosity, "fluid: artificial viscosity", "Antoci2007 eq. 12"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_fluid(c), "alpha", s.method.fluid.artificial_viscosity, 0);
     }},
    {{Effect::velocity_filter, "fluid: velocity filter", "Antoci2007 eq. 16"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_fluid(c), "theta", s.method.fluid.velocity_filter, 1);
     }},
    {{Effect::solid_stress, "solid: continuity, hypoelastic stress with Jaumann rate",
      "Antoci2007 eqs. 4, 5, 8, 11, 15"},
     [](const Scene&, const SceneContent& c) { return needs_solid(c); }},
    {{Effect::solid_viscosity, "solid: artificial viscosity", "Antoci2007 eq. 12"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_solid(c), "alpha", s.method.solid.artificial_viscosity, 0);
     }},
    {{Effect::artificial_stress, "solid: artificial stress", "Antoci2007 eqs. 13, 14"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_solid(c), "e", s.method.solid.artificial_stress, 0);
     }},
    {{Effect::solid_filter, "solid: velocity filter", "Antoci2007 eq. 16"},
     [](const Scene& s, const SceneContent& c) {
         return by_constant(needs_solid(c), "theta", s.method.solid.velocity_filter, 1);
     }},
    {{Effect::interface_force, "interface: force, reaction and kinematic condition", "Antoci2007 eqs. 24-30"},
     [](const Scene&, const SceneContent& c) {
         if (!c.fluid || !c.solid) return Decision{false, c.fluid ? "no solid body" : "no fluid body"};
         return Decision{true, fmt::format("{} can meet {}", c.fluids, c.solids)};
     }},
    {{Effect::mirror_wall, "walls: mirrored ghosts (slip)", "Antoci2007 sect. 4"},
     [](const Scene&, const SceneContent& c) {
         if (!c.mirror) return Decision{false, "no mirror wall"};
         return c.fluid ? Decision{true, "walls: " + c.mirrors} : Decision{false, "no fluid body to mirror"};
     }},
    {{Effect::fixed_wall, "walls: layers of fixed ghosts", "Antoci2007 sect. 4; Adami2012 eq. 27"},
     [](const Scene&, const SceneContent& c) {
         if (!c.fixed) return Decision{false, "no fixed wall"};
         return c.fluid ? Decision{true, "walls: " + c.fixed_walls} : Decision{false, "no fluid body to hold"};
     }},
    {{Effect::clamp, "solid: clamp", "Antoci2007 sect. 4"},
     [](const Scene&, const SceneContent& c) {
         return c.clamp ? Decision{true, "bodies: " + c.clamps} : Decision{false, "no clamped body"};
     }},
    {{Effect::gravity, "gravity", "Antoci2007 eq. 2"},
     [](const Scene& s, const SceneContent& c) {
         if (!c.gravity) return Decision{false, "gravity = 0"};
         return Decision{true, fmt::format("g = ({}, {}, {}) m/s2", s.gravity[0], s.gravity[1], s.gravity[2])};
     }},
    {{Effect::variable_resolution, "pairs of unequal size: mean smoothing length", "kernels/pair.hpp"},
     [](const Scene&, const SceneContent& c) {
         return c.many_spacings ? Decision{true, "bodies of different spacing"} : Decision{false, "one spacing"};
     }},
}};

}  // namespace

Effects::Effects(const Scene& scene) {
    const SceneContent content = look_at(scene);
    for (const Row& row : table) {
        const Decision d = row.rule(scene, content);
        choices_[static_cast<std::size_t>(row.info.effect)] = {row.info, d.on, d.why};
    }
}

}  // namespace sluice
