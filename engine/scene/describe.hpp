// How messages name places, bodies and lines.
#pragma once

#include <string>

#include "engine/scene/scene.hpp"

namespace sluice {

/// "(0.1, 0.2)", with as many components as the scene has dimensions.
std::string describe_place(const Scene& scene, const Point& p);

/// `bodies.gate (line 12)`; without the line if the file does not state the key.
std::string describe_key(const Scene& scene, const std::string& key);

/// `file:line: key: message`, as messages begin.
std::string located(const Scene& scene, const std::string& key, const std::string& message);

/// The key that states a body's or wall's spacing; `owner` is e.g. "bodies.gate".
std::string spacing_key(const Scene& scene, const std::string& owner);

}  // namespace sluice
