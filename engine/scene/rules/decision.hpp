// What a rule answers, and the answers that many rules share.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/scene/rules/scene_content.hpp"

namespace sluice {

/// A rule's answer.
struct Decision {
    enum class Verdict {
        impossible,  ///< the scene has nothing for it to act on
        unused,      ///< could act, but the scene does not call for it
        used,        ///< the scene calls for it
        required     ///< the scene calls for it and cannot do without
    };
    Verdict verdict = Verdict::impossible;
    std::string why;

    bool is_impossible() const { return verdict == Verdict::impossible; }
    /// Whether "auto" turns the effect on.
    bool is_called_for() const { return verdict == Verdict::used || verdict == Verdict::required; }
};

namespace rules {

inline Decision impossible(std::string why) { return {Decision::Verdict::impossible, std::move(why)}; }
inline Decision unused(std::string why) { return {Decision::Verdict::unused, std::move(why)}; }
inline Decision used(std::string why) { return {Decision::Verdict::used, std::move(why)}; }
inline Decision required(std::string why) { return {Decision::Verdict::required, std::move(why)}; }

// Required if the scene has the medium, impossible if not.
Decision fluid_in(const SceneContent& content);
Decision solid_in(const SceneContent& content);
Decision hypoelastic_solid_in(const SceneContent& content);
Decision total_lagrangian_solid_in(const SceneContent& content);

/// Required if bodies are of several materials, impossible if not; `otherwise` says why.
Decision by_materials(const std::vector<std::string>& materials, std::string_view otherwise);

/// Used if its medium is there and its constant differs from the value at which the term vanishes.
Decision by_constant(const Decision& medium, std::string_view symbol, double value, double off_value);

}  // namespace rules
}  // namespace sluice
