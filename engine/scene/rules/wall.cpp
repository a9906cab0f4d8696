// Rules of walls and of the periodic box.
#include <fmt/format.h>

#include "engine/scene/rules/rules.hpp"

namespace sluice::rules {

Decision mirror_wall(const Grounds<Effect::mirror_wall>& g) {
    if (!g.content.mirror) return impossible("no mirror wall");
    return g.content.fluid ? required("walls: " + g.content.mirrors) : impossible("no fluid body to mirror");
}

Decision fixed_wall(const Grounds<Effect::fixed_wall>& g) {
    if (!g.content.fixed) return impossible("no fixed wall");
    return g.content.fluid ? required("walls: " + g.content.fixed_walls) : impossible("no fluid body to hold");
}

Decision no_slip_wall(const Grounds<Effect::no_slip_wall>& g) {
    if (!g.content.no_slip)
        return impossible(fmt::format("no wall with condition = {}", quoted_word<WallCondition::no_slip>));
    return g.content.viscous ? used("walls: " + g.content.no_slip_walls) : impossible("viscosity = 0");
}

Decision moving_wall(const Grounds<Effect::moving_wall>& g) {
    if (!g.content.moving_wall) return impossible("no wall with a motion");
    const bool is_felt = g.content.fluid || g.has<Effect::contact>();
    return is_felt ? used("walls: " + g.content.moving_walls) : impossible("no fluid body to move");
}

Decision periodic_box(const Grounds<Effect::periodic_box>& g) {
    if (g.content.periodic_axes.empty()) return impossible("no periodic axis");
    return g.content.fluid ? required("along " + g.content.periodic_axes) : fluid_in(g.content);
}

}  // namespace sluice::rules
