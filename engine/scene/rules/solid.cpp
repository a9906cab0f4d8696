// Rules of what acts within solids and among them.
#include <fmt/format.h>

#include "engine/scene/rules/rules.hpp"

namespace sluice::rules {
namespace {

/// Names of all walls.
std::string walls_of(const SceneContent& c) {
    return c.mirrors + (c.mirrors.empty() || c.fixed_walls.empty() ? "" : ", ") + c.fixed_walls;
}

}  // namespace

Decision solid_stress(const Grounds<Effect::solid_stress>& g) { return hypoelastic_solid_in(g.content); }

Decision total_lagrangian(const Grounds<Effect::total_lagrangian>& g) { return total_lagrangian_solid_in(g.content); }

Decision hourglass_control(const Grounds<Effect::hourglass_control>& g) {
    return by_constant(total_lagrangian_solid_in(g.content), "zeta", g.scene.method.solid.hourglass_control, 0);
}

Decision solid_viscosity(const Grounds<Effect::solid_viscosity>& g) {
    return by_constant(solid_in(g.content), "alpha", g.scene.method.solid.artificial_viscosity, 0);
}

Decision artificial_stress(const Grounds<Effect::artificial_stress>& g) {
    return by_constant(hypoelastic_solid_in(g.content), "e", g.scene.method.solid.artificial_stress, 0);
}

Decision solid_filter(const Grounds<Effect::solid_filter>& g) {
    return by_constant(hypoelastic_solid_in(g.content), "theta", g.scene.method.solid.velocity_filter, 1);
}

Decision several_solids(const Grounds<Effect::several_solids>& g) {
    return g.content.solid ? by_materials(g.content.solid_materials, "one solid material") : solid_in(g.content);
}

Decision contact(const Grounds<Effect::contact>& g) {
    const SceneContent& c = g.content;
    if (!c.solid) return solid_in(c);
    if (!c.movable) return impossible("all solid bodies are clamped");
    const std::string walls = walls_of(c);
    if (!c.total_lagrangian) {
        if (walls.empty()) return impossible("no wall, and the solids are hypoelastic");
        return unused("the solids are hypoelastic; they could meet walls: " + walls);
    }
    if (c.total_lagrangian_bodies < 2 && !c.hypoelastic && walls.empty())
        return impossible("one solid body and no wall");
    if (walls.empty()) return used(fmt::format("solid bodies: {}", c.solids));
    return used(fmt::format("solid bodies: {}; walls: {}", c.solids, walls));
}

Decision clamp(const Grounds<Effect::clamp>& g) {
    return g.content.clamp ? required("bodies: " + g.content.clamps) : impossible("no clamped body");
}

Decision clamp_extension(const Grounds<Effect::clamp_extension>& g) {
    const Decision& solid = g.decision<Effect::total_lagrangian>();
    if (solid.is_impossible()) return solid;
    const Decision& held = g.decision<Effect::clamp>();
    return held.is_impossible() ? held : used(held.why);
}

}  // namespace sluice::rules
