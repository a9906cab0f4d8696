// What the effects are, from the one table (effects.def): keys, names, sources, columns and formulas.
#pragma once

#include <string_view>

#include "engine/scene/effects/effect.hpp"
#include "engine/scene/effects/set_id.hpp"
#include "kernels/columns/column_table.hpp"

namespace sluice {

/// A row of the table; effects.def says what its entries are.
struct EffectInfo {
    Effect effect;
    std::string_view key, name, equation;
    std::string_view fields;  ///< "phase.column phase.column"
    std::string_view automatic, formula, places;

    bool needs(SetId set, Column column) const;
};

namespace effect_fields {
inline constexpr std::string_view fluid =
    "fluid.position fluid.velocity fluid.acceleration fluid.density fluid.density_rate fluid.pressure fluid.mass "
    "fluid.smoothing_length fluid.id fluid.body fluid.pressure_over_rho2";
#define SLUICE_SOLID_FIELDS                                                                     \
    "solid.position solid.velocity solid.acceleration solid.density solid.pressure solid.mass " \
    "solid.smoothing_length solid.id solid.body solid.clamped "
inline constexpr std::string_view hypoelastic =
    SLUICE_SOLID_FIELDS "solid.density_rate solid.deviatoric_stress solid.stress_over_rho2 solid.velocity_gradient";
inline constexpr std::string_view total_lagrangian = SLUICE_SOLID_FIELDS
    "solid.reference_position solid.volume solid.deformation solid.corrected_stress solid.gradient_correction "
    "solid.hourglass_stiffness";
#undef SLUICE_SOLID_FIELDS
inline constexpr std::string_view elements =
    "elements.position elements.area_normal elements.velocity elements.pressure elements.image_pressure "
    "elements.solid_weight elements.force elements.shared_force elements.smoothing_length elements.body "
    "solid.interface_acceleration solid.halfway_position solid.mean_velocity";
inline constexpr std::string_view boundary =
    "boundary.position boundary.velocity boundary.mean_acceleration boundary.volume boundary.smoothing_length "
    "boundary.force boundary.solid_id boundary.body solid.interface_acceleration solid.halfway_position "
    "solid.mean_velocity solid.mean_acceleration";
inline constexpr std::string_view wall =
    "wall.position wall.pressure wall.volume wall.smoothing_length wall.id wall.body";
}  // namespace effect_fields

/// In the order of Effect.
inline constexpr EffectInfo effect_table[] = {
#define SLUICE_EFFECT(key, name, equation, fields, automatic, formula, places) \
    {Effect::key, #key, name, equation, fields, automatic, formula, places},
#include "engine/scene/effects/effects.def"
#undef SLUICE_EFFECT
};

constexpr const EffectInfo& info_of(Effect e) { return effect_table[static_cast<std::size_t>(e)]; }

/// The effect of this key; null without one.
constexpr const EffectInfo* find_effect(std::string_view key) {
    for (const EffectInfo& info : effect_table)
        if (info.key == key) return &info;
    return nullptr;
}

}  // namespace sluice
