// Makes the couplings that a scene calls for.
#pragma once

#include <memory>
#include <vector>

#include "engine/step/context.hpp"
#include "engine/step/coupling.hpp"

namespace sluice {

/// Returns them in the order in which each stage of a step calls them.
template <int Dim>
std::vector<std::unique_ptr<Coupling<Dim>>> make_couplings(StepContext<Dim>& context);

}  // namespace sluice
