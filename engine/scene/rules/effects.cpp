#include "engine/scene/rules/effects.hpp"

#include <fmt/format.h>

#include "engine/scene/rules/rules.hpp"

namespace sluice {
namespace {

using Verdict = Decision::Verdict;

/// Throws SceneError if [effects] asks for what the rule says cannot be.
void check_switch(const Scene& scene, const EffectInfo& info, const Decision& d) {
    const Switch asked = scene.switches[info.effect];
    const std::string path = fmt::format("effects.{}", info.key);
    if (asked == Switch::on && d.verdict == Verdict::impossible)
        scene.fail(path, fmt::format("found {}, but there is nothing for it to act on: {}; expected {} or {}",
                                     quoted_word<Switch::on>, d.why, quoted_word<Switch::automatic>,
                                     quoted_word<Switch::off>));
    if (asked == Switch::off && d.verdict == Verdict::required)
        scene.fail(path, fmt::format("found {}, but the scene cannot do without: {}; expected {} or {}",
                                     quoted_word<Switch::off>, d.why, quoted_word<Switch::automatic>,
                                     quoted_word<Switch::on>));
}

EffectChoice choose(const Scene& scene, const EffectInfo& info, const Decision& d) {
    check_switch(scene, info, d);
    switch (scene.switches[info.effect]) {
        case Switch::automatic:
            break;
        case Switch::on:
            return {info, d, true, "switched on; " + d.why};
        case Switch::off:
            return {info, d, false, d.is_called_for() ? "switched off; " + d.why : d.why};
    }
    return {info, d, d.is_called_for(), d.why};
}

}  // namespace

Effects::Effects(const Scene& scene) {
    const SceneContent content = content_of(scene);
#define SLUICE_EFFECT(key, ...) \
    choices_[Effect::key] =     \
        choose(scene, info_of(Effect::key), rules::key(Grounds<Effect::key>(scene, content, choices_)));
#include "engine/scene/effects/effects.def"
#undef SLUICE_EFFECT
}

bool Effects::needs(SetId set, Column column) const {
    for (const EffectChoice& choice : choices_)
        if (choice.on && choice.info.columns.has(set, column)) return true;
    return false;
}

}  // namespace sluice
