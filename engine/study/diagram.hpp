// The work-precision diagram of one quantity.
#pragma once

#include "engine/study/study.hpp"
#include "engine/study/svg.hpp"

namespace sluice {

/// Error over CPU seconds, both logarithmic: a line per method with its spacings, slopes of cost and error, the Pareto
/// front, and the truth's own uncertainty as a band. Each run is an element of class "point".
Svg diagram(const Study& study, std::size_t quantity);

}  // namespace sluice
