// What the effects are, in words: printed from the table of effects, so that it says what the program does.
#pragma once

#include <string>

#include "engine/scene/effects/effect_table.hpp"

namespace sluice {

/// Every effect in a line: key, what it is, and when "auto" turns it on.
std::string effect_list();

/// One effect: what it is, its rule, formula, source, and fields with their bytes per particle in 2D and 3D.
std::string effect_page(const EffectInfo& effect);

/// All of it as Markdown: engine/EFFECTS.md.
std::string effects_document();

}  // namespace sluice
