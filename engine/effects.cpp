#include "engine/effects.hpp"

#include <fmt/format.h>

#include "engine/effect_table.hpp"

namespace sluice {
namespace {

using Verdict = Decision::Verdict;

EffectChoice choose(const Scene& scene, const EffectRow& row, const SceneContent& content) {
    const Decision d = row.rule(scene, content);
    const auto asked = scene.switches.find(std::string(row.info.key));
    const Switch wish = asked == scene.switches.end() ? Switch::automatic : asked->second;
    const std::string path = fmt::format("effects.{}", row.info.key);
    if (wish == Switch::on && d.verdict == Verdict::impossible)
        scene.fail(path, fmt::format("found \"on\", but there is nothing for it to act on: {}; expected \"auto\" or "
                                     "\"off\"",
                                     d.why));
    if (wish == Switch::off && d.verdict == Verdict::required)
        scene.fail(path, fmt::format("found \"off\", but the scene cannot do without: {}; expected \"auto\" or \"on\"",
                                     d.why));
    if (wish == Switch::on) return {row.info, true, "switched on; " + d.why};
    if (wish == Switch::off && d.verdict == Verdict::used) return {row.info, false, "switched off; " + d.why};
    return {row.info, d.verdict == Verdict::used || d.verdict == Verdict::required, d.why};
}

}  // namespace

bool EffectInfo::needs(SetId set, Column of) const {
    const std::string_view phase = name_of(set), column = info_of(of).name;
    for (std::size_t at = 0; at < fields.size();) {
        const std::size_t end = std::min(fields.find(' ', at), fields.size());
        const std::string_view word = fields.substr(at, end - at);
        if (word.size() == phase.size() + 1 + column.size() && word.starts_with(phase) && word.ends_with(column) &&
            word[phase.size()] == '.')
            return true;
        at = end + 1;
    }
    return false;
}

Effects::Effects(const Scene& scene) {
    const SceneContent content = content_of(scene);
    for (const EffectRow& row : effect_table())
        choices_[static_cast<std::size_t>(row.info.effect)] = choose(scene, row, content);
}

bool Effects::needs(SetId set, Column column) const {
    for (const EffectChoice& choice : choices_)
        if (choice.on && choice.info.needs(set, column)) return true;
    return false;
}

}  // namespace sluice
