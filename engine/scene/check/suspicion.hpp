// Values that a scene may have, but that look like a slip of units or a key forgotten: told, not refused.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace sluice {

/// "file:line: key: found …, …" each. Units are doubted under the gravity of the earth only: without it, scenes are
/// often dimensionless.
std::vector<std::string> suspicious_values(const Scene& scene);

}  // namespace sluice
