// The one table of effects: names, sources, fields, and the rules by which a scene calls for them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "engine/effects.hpp"
#include "engine/effects/names/step_phase.hpp"

namespace sluice {

/// What the rules look at.
struct SceneContent {
    bool fluid = false, solid = false, hypoelastic = false, total_lagrangian = false, clamp = false, mirror = false,
         fixed = false, gravity = false;
    bool movable = false;  ///< a solid body that is not clamped altogether
    int total_lagrangian_bodies = 0;
    bool no_slip = false, viscous = false, moving_wall = false, driven = false, many_spacings = false;
    /// Materials of the bodies, each once.
    std::vector<std::string> fluid_materials, solid_materials;
    std::string fluids, solids, clamps, mirrors, fixed_walls, moving_walls, no_slip_walls,
        periodic_axes;  ///< names, for messages
};
SceneContent content_of(const Scene& scene);

/// A rule's answer.
struct Decision {
    enum class Verdict {
        impossible,  ///< the scene has nothing for it to act on
        unused,      ///< could act, but the scene does not call for it
        used,        ///< the scene calls for it
        required     ///< nor can it be left out
    };
    Verdict verdict;
    std::string why;
};

struct EffectRow {
    EffectInfo info;
    Decision (*rule)(const Scene&, const SceneContent&);
    std::vector<StepPhase> phases = {};  ///< of a step that run for this effect, if it is required
};

/// In the order of the enumeration.
std::span<const EffectRow> effect_table();

}  // namespace sluice
