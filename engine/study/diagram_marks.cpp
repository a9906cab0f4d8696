#include "engine/study/diagram_marks.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace sluice {
namespace {

// Okabe & Ito's palette without yellow and black, the darker ones first.
constexpr std::array<const char*, 6> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr std::array<const char*, 3> dashes{"", " stroke-dasharray=\"7 4\"", " stroke-dasharray=\"2 3\""};

/// Corners of a regular polygon, 0 = a circle, and the turn of the first corner from straight up.
struct MarkShape {
    int corners;
    double turn;
    double radius;  ///< [px]; such that all cover about the same area
};
constexpr double pi = std::numbers::pi;
constexpr std::array<MarkShape, 6> shapes{
    {{0, 0, 4.3}, {4, pi / 4, 5.4}, {3, 0, 6.2}, {4, 0, 5.6}, {3, pi, 6.2}, {5, 0, 5.0}}};

std::string raised(const std::string& exponent, double size) {
    return fmt::format("<tspan dy=\"{:.1f}\" font-size=\"{:.1f}\">{}</tspan><tspan dy=\"{:.1f}\">&#8203;</tspan>",
                       -0.4 * size, 0.82 * size, exponent, 0.4 * size);
}

}  // namespace

LineStyle line_style(std::size_t method) {
    return {colours[method % colours.size()], (method + method / colours.size()) % shapes.size(),
            dashes[method / colours.size() % dashes.size()]};
}

std::string mark_element(const LineStyle& style, Place at, const std::string& attributes, const std::string& title) {
    const MarkShape shape = shapes[style.shape];
    const std::string inside = title.empty() ? "" : fmt::format("<title>{}</title>", xml_text(title));
    if (shape.corners == 0)
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}>{}</circle>", at.x, at.y, shape.radius,
                           attributes, inside);
    std::string corners;
    for (int k = 0; k < shape.corners; ++k) {
        const double angle = shape.turn + 2 * pi * k / shape.corners;
        corners += fmt::format("{}{:.1f},{:.1f}", k == 0 ? "" : " ", at.x + shape.radius * std::sin(angle),
                               at.y - shape.radius * std::cos(angle));
    }
    return fmt::format("<polygon points=\"{}\" {}>{}</polygon>", corners, attributes, inside);
}

Slopes slopes_of(const std::vector<const StudyPoint*>& points, std::size_t quantity) {
    std::vector<double> spacing, cost, error;
    for (const StudyPoint* p : points) {
        spacing.push_back(p->spacing);
        cost.push_back(p->cpu_seconds());
        error.push_back(*p->error[quantity]);
    }
    return {fit_power(spacing, cost), fit_power(spacing, error)};
}

std::string exponent_text(const PowerFit& fit) {
    const char* sign = fit.exponent < 0 ? "−" : "";
    std::string text = fmt::format("{}{:.2f}", sign, std::abs(fit.exponent));
    if (fit.uncertainty) text += fmt::format(" ± {:.2f}", *fit.uncertainty);
    return text;
}

std::string slopes_element(Place at, const Slopes& slopes, double size) {
    std::string words;
    if (slopes.cost) words += "cost ~ d" + raised(exponent_text(*slopes.cost), size);
    if (slopes.error)
        words += std::string(words.empty() ? "" : "   ") + "error ~ d" + raised(exponent_text(*slopes.error), size);
    if (words.empty()) words = "one spacing only";
    return fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" fill=\"#555555\" xml:space=\"preserve\">{}</text>", at.x,
        at.y, size, words);
}

}  // namespace sluice
