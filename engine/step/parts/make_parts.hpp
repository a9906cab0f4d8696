// The parts that a scene calls for.
#pragma once

#include <memory>
#include <vector>

#include "engine/step/context.hpp"
#include "engine/step/part.hpp"

namespace sluice {

/// In the order in which the stages of a step go through them.
template <int Dim>
std::vector<std::unique_ptr<Part<Dim>>> make_parts(StepContext<Dim>& context);

}  // namespace sluice
