// What the effects are, from the one table (effects.def): keys, names, sources, columns and formulas.
#pragma once

#include <span>
#include <string_view>

#include "engine/scene/effects/effect.hpp"
#include "engine/scene/effects/needed_columns.hpp"
#include "engine/scene/effects/step_place.hpp"

namespace sluice {

/// A row of the table; effects.def says what its entries are.
struct EffectInfo {
    Effect effect;
    std::string_view key, name, equation;
    NeededColumns columns;
    std::string_view automatic, formula;
    StepPlaces places;
};

namespace needed {
using namespace step_places;
inline constexpr EffectInfo effect_rows[] = {
#define SLUICE_EFFECT(key, name, equation, columns, automatic, formula, places) \
    {Effect::key, #key, name, equation, columns, automatic, formula, places},
#include "engine/scene/effects/effects.def"
#undef SLUICE_EFFECT
};
}  // namespace needed

/// In the order of Effect.
inline constexpr std::span<const EffectInfo, effect_count> effect_table = needed::effect_rows;

constexpr const EffectInfo& info_of(Effect e) { return effect_table[static_cast<std::size_t>(e)]; }

/// The effect of this key; null without one.
constexpr const EffectInfo* find_effect(std::string_view key) {
    for (const EffectInfo& info : effect_table)
        if (info.key == key) return &info;
    return nullptr;
}

}  // namespace sluice
