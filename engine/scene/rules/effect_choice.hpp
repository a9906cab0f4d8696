// What a scene makes of one effect: what its rule answers, and what [effects] says to that.
#pragma once

#include <string>

#include "engine/scene/effects/effect_table.hpp"
#include "engine/scene/rules/decision.hpp"

namespace sluice {

struct EffectChoice {
    EffectInfo info;
    Decision decision;  ///< of its rule, whatever [effects] asks for
    bool on = false;    ///< by the rule, or by [effects]
    std::string why;    ///< the rule's reason, and whether [effects] had the last word
};

}  // namespace sluice
