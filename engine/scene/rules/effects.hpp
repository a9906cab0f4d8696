// Which effects a scene calls for, and why: loops, allocation, output and messages follow from it.
#pragma once

#include "engine/scene/rules/effect_choice.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

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
