// The matrix of a study: which keys are varied, over which values.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/study/study.hpp"

namespace sluice {

/// `key.path=V1,V2,…`; commas inside brackets and quotes do not separate. A value x0.5 stands for half of what the
/// scene has. Throws SceneError.
Axis parse_axis(const std::string& text, const Scene& scene);

/// Every combination of the axes' values, the last axis changing fastest.
std::vector<std::vector<std::string>> combinations(const std::vector<Axis>& axes);

/// What a combination is called, its spacing left out: "modern, mixed, courant 0.5"; the scene's preset and precision
/// if nothing else is varied.
std::string method_name(const std::vector<Axis>& axes, const std::vector<std::string>& values, const Scene& scene);

/// key=value for each axis.
std::vector<std::string> overrides_of(const std::vector<Axis>& axes, const std::vector<std::string>& values);

/// What the scene has at a key, as its file or its preset says; empty if neither does.
std::string value_in_scene(const Scene& scene, const std::string& key);

/// Whether two values of a key are the same: as numbers if they are numbers, quotes aside.
bool is_same_value(const std::string& a, const std::string& b);

/// Tells scenes apart by all that changes the physics save for the keys given and the spacing: title, probes, when
/// they are written, and references do not count.
std::string fingerprint(const Scene& scene, const std::vector<Axis>& axes);

}  // namespace sluice
