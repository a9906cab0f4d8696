// How a method looks in a diagram, and its slopes in words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/study/fit.hpp"
#include "engine/study/study.hpp"
#include "engine/study/svg.hpp"

namespace sluice {

struct LineStyle {
    std::string colour;
    std::size_t shape = 0;
    std::string dash;  ///< attribute, or nothing
};

/// Colours that colour-blind readers can tell apart [Okabe & Ito 2008], and shapes for those who print in grey.
LineStyle line_style(std::size_t method);

/// A mark of the style's shape; `title` shows when the pointer rests on it.
std::string mark_element(const LineStyle& style, Place at, const std::string& attributes, const std::string& title);

/// cost ~ d^exponent, error ~ d^exponent
struct Slopes {
    std::optional<PowerFit> cost, error;
};
Slopes slopes_of(const std::vector<const StudyPoint*>& points, std::size_t quantity);

/// "−3.1 ± 0.1"
std::string exponent_text(const PowerFit& fit);

/// "cost ~ d^−3.1 ± 0.1, error ~ d^1.9 ± 0.3" with raised exponents.
std::string slopes_element(Place at, const Slopes& slopes, double size);

}  // namespace sluice
