// Which effects a scene calls for, and why: loops, allocation, output and messages follow from it.
#pragma once

#include <string>

#include "engine/effects/names/effect_table.hpp"
#include "engine/effects/rules/decision.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

/// What a scene makes of one effect.
struct EffectChoice {
    EffectInfo info;
    Decision decision;  ///< of its rule, whatever [effects] asks for
    bool on = false;    ///< by the rule, or by [effects]
    std::string why;    ///< the rule's reason, and whether [effects] had the last word
};

class Effects {
  public:
    /// Throws SceneError where [effects] asks for what cannot be.
    explicit Effects(const Scene& scene);
    bool has(Effect e) const { return choices_[e].on; }
    const EffectChoice& operator[](Effect e) const { return choices_[e]; }
    const PerEffect<EffectChoice>& all() const { return choices_; }
    /// Whether an effect that is on needs this column of this set.
    bool needs(SetId set, Column column) const;

  private:
    PerEffect<EffectChoice> choices_;
};

}  // namespace sluice
