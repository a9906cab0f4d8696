// From probe curves to errors.
#pragma once

#include <optional>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/study/curve.hpp"
#include "engine/study/study.hpp"

namespace sluice {

/// Fills the study's quantities and each point's errors. `curves`: the probes of each point; none = not run or failed.
/// Throws SceneError for references without a size.
void measure_errors(Study& study, const Scene& scene, const std::vector<std::optional<ProbeTable>>& curves);

}  // namespace sluice
