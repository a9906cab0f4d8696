// The study as pictures and as a page that stands alone.
#pragma once

#include <string>
#include <vector>

#include "engine/study/study.hpp"

namespace sluice {

/// Diagrams of all quantities whose truth is stated, one below the other; of all if none is.
std::string study_svg(const Study& study);

/// Advice, diagrams, slopes, all runs and those that failed, as one HTML file without links.
std::string study_page(const Study& study);

}  // namespace sluice
