// The rules of the effects, one each: what "auto" means in a scene.
#pragma once

#include "engine/scene/rules/effect_choice.hpp"

namespace sluice {

/// What the rule of an effect goes by: the scene, and the choices made for effects above it in the table.
template <Effect of>
class Grounds {
  public:
    Grounds(const Scene& s, const SceneContent& c, const PerEffect<EffectChoice>& choices)
        : scene(s), content(c), choices_(choices) {}

    const Scene& scene;
    const SceneContent& content;

    /// The answer of another effect's rule, whatever [effects] asks for.
    template <Effect other>
    const Decision& decision() const {
        return choice<other>().decision;
    }
    /// Whether another effect is on.
    template <Effect other>
    bool has() const {
        return choice<other>().on;
    }

  private:
    template <Effect other>
    const EffectChoice& choice() const {
        static_assert(other < of, "a rule may only ask for effects that stand above its own in the table");
        return choices_[other];
    }

    const PerEffect<EffectChoice>& choices_;
};

namespace rules {
#define SLUICE_EFFECT(key, ...) Decision key(const Grounds<Effect::key>& grounds);
#include "engine/scene/effects/effects.def"
#undef SLUICE_EFFECT
}  // namespace rules

}  // namespace sluice
