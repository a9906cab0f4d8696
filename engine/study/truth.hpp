// What a scene's references say, made ready to be compared with a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/study/curve.hpp"

namespace sluice {

/// The scene's references, and one for each displacement, pressure or level that has none: the finest runs stand in for
/// their truth. A scene with nothing of all that is measured by its kinetic energy.
std::vector<Reference> references_of(const Scene& scene);

/// How far a run is from a stated reference, in the probe's unit (times: s); none if it cannot be told.
std::optional<double> stated_error(const Scene& scene, const Reference& reference, const Curve& run);

/// What an error of 100 % is for a stated reference: its scale; else the largest size of its curve, or of its number.
/// Throws SceneError if that is 0.
double scale_of(const Scene& scene, const Reference& reference);

/// What is compared with what: "RMS distance of free_end.x from reference.csv, 0.04 to 0.36 s".
std::string meaning_of(const Reference& reference);

}  // namespace sluice
