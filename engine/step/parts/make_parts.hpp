// Makes the parts that a scene calls for.
#pragma once

#include <memory>
#include <vector>

#include "engine/step/context.hpp"
#include "engine/step/part.hpp"

namespace sluice {

/// Returns them in the order in which each stage of a step calls them.
template <int Dim>
std::vector<std::unique_ptr<Part<Dim>>> make_parts(StepContext<Dim>& context);

}  // namespace sluice
