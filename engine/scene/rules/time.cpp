// Rules of what drives a scene, of resolution, and of time steps.
#include <fmt/format.h>

#include "engine/scene/rules/rules.hpp"

namespace sluice::rules {

Decision gravity(const Grounds<Effect::gravity>& g) {
    if (!g.content.gravity) return impossible("gravity = 0");
    const Point& a = g.scene.gravity;
    return used(fmt::format("g = ({}, {}, {}) m/s2", a[0], a[1], a[2]));
}

Decision driven_acceleration(const Grounds<Effect::driven_acceleration>& g) {
    if (!g.content.driven) return impossible("no acceleration in the scene");
    return used(fmt::format("a(t) = ({}) m/s2", fmt::join(g.scene.acceleration, ", ")));
}

Decision variable_resolution(const Grounds<Effect::variable_resolution>& g) {
    return g.content.many_spacings ? required("bodies of different spacing") : impossible("one spacing");
}

Decision adaptive_step(const Grounds<Effect::adaptive_step>& g) {
    if (g.scene.method.time_step) return impossible("method.time_step states it");
    const StepSize size = g.scene.method.step_size;
    return size == StepSize::adaptive ? used("method.step_size")
                                      : unused(fmt::format("method.step_size = \"{}\"", word_of(size)));
}

Decision solid_substeps(const Grounds<Effect::solid_substeps>& g) {
    if (!g.content.fluid || !g.content.solid) return impossible("one medium");
    const TimeStepping rate = g.scene.method.time_stepping;
    return rate == TimeStepping::multi_rate ? used("method.time_stepping")
                                            : unused(fmt::format("method.time_stepping = \"{}\"", word_of(rate)));
}

Decision steady_load(const Grounds<Effect::steady_load>& g) {
    const Decision& substeps = g.decision<Effect::solid_substeps>();
    if (substeps.is_impossible()) return substeps;
    if (!g.content.total_lagrangian) return impossible("the solids are hypoelastic");
    if (!g.has<Effect::solid_substeps>()) return impossible("the solid has no steps of its own");
    return used(fmt::format("load of {} on {}", g.content.fluids, g.content.solids));
}

}  // namespace sluice::rules
