// Rules of how fluid and solids feel each other.
#include <fmt/format.h>

#include "engine/scene/rules/rules.hpp"

namespace sluice::rules {
namespace {

/// Required if fluid and solids meet in this way.
Decision meeting(const Scene& scene, const SceneContent& c, CouplingScheme scheme) {
    if (!c.fluid || !c.solid) return c.fluid ? solid_in(c) : fluid_in(c);
    if (scheme != scene.method.coupling) return impossible("method.coupling is another");
    return required(fmt::format("{} can meet {}", c.fluids, c.solids));
}

}  // namespace

Decision interface_force(const Grounds<Effect::interface_force>& g) {
    return meeting(g.scene, g.content, CouplingScheme::interface_force);
}

Decision moving_boundary(const Grounds<Effect::moving_boundary>& g) {
    return meeting(g.scene, g.content, CouplingScheme::moving_boundary);
}

Decision no_slip_solid(const Grounds<Effect::no_slip_solid>& g) {
    const Decision& boundary = g.decision<Effect::moving_boundary>();
    if (boundary.is_impossible()) return boundary;
    return g.content.viscous ? used("a viscous fluid sticks to solids") : impossible("viscosity = 0");
}

}  // namespace sluice::rules
