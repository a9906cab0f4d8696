// The couplings that a scene calls for.
#pragma once

#include <memory>
#include <vector>

#include "engine/step/context.hpp"
#include "engine/step/coupling.hpp"

namespace sluice {

/// In the order in which the stages of a step go through them.
template <int Dim>
std::vector<std::unique_ptr<Coupling<Dim>>> make_couplings(StepContext<Dim>& context);

}  // namespace sluice
