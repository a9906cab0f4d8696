// The columns that a probe writes, known before there are particles.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace sluice {

/// As in probes.csv, without their units: "free_end.x".
std::vector<std::string> probe_columns(const Probe& probe, int dimension);

}  // namespace sluice
