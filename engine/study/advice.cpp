#include "engine/study/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/study/fit.hpp"
#include "engine/study/words.hpp"

namespace sluice {
namespace {

using Points = std::vector<const StudyPoint*>;

/// Spacings within this of each other are the same, differently rounded.
constexpr double same_spacing = 0.005;
/// Likewise errors: a target of 1 % is met by 0.1² as computers have it.
constexpr double same_error = 1e-9;
/// How far beyond the finest spacing slopes are followed.
constexpr double reach = 0.5;
constexpr double least_slope = 0.5;
/// Methods that a sentence names.
constexpr std::size_t most_named = 4;

double error_of(const StudyPoint* p, std::size_t quantity) { return *p->error[quantity]; }

/// Slope of error over spacing if it may be followed.
std::optional<double> error_slope(const Points& points, std::size_t quantity) {
    std::vector<double> spacing, error;
    for (const StudyPoint* p : points) {
        spacing.push_back(p->spacing);
        error.push_back(error_of(p, quantity));
    }
    if (points.size() < 3) return std::nullopt;
    // What has levelled off does not fall again, however steep it was before.
    const std::size_t n = points.size();
    const auto last = fit_power({spacing[n - 2], spacing[n - 1]}, {error[n - 2], error[n - 1]});
    if (!last || last->exponent < least_slope) return std::nullopt;
    const auto fit = fit_power(spacing, error);
    if (!fit || fit->exponent < least_slope || fit->exponent < 2 * fit->uncertainty.value_or(0)) return std::nullopt;
    return fit->exponent;
}

/// Slope of cost over spacing; particles and steps, d^-(Dim + 1), where it cannot be fitted.
double cost_slope(const Study& study, const Points& points) {
    std::vector<double> spacing, cost;
    for (const StudyPoint* p : points) {
        spacing.push_back(p->spacing);
        cost.push_back(p->cpu_seconds());
    }
    const auto fit = fit_power(spacing, cost);
    return fit ? fit->exponent : -(study.dimension + 1);
}

Choice measured(const StudyPoint* p, std::size_t quantity) {
    return {p->method, p->spacing, p->cpu_seconds(), error_of(p, quantity), Basis::measured};
}

/// Part `share` of the way from a to b, in logarithms.
double between(double a, double b, double share) { return a * std::pow(b / a, share); }

Choice between(const Choice& a, const Choice& b, double share) {
    return {a.method, between(a.spacing, b.spacing, share), between(a.cpu, b.cpu, share),
            between(a.error, b.error, share), Basis::interpolated};
}

std::optional<Choice> beyond(const Study& study, std::size_t quantity, const Points& points, double spacing) {
    const auto slope = error_slope(points, quantity);
    const Choice last = measured(points.back(), quantity);
    const double ratio = spacing / last.spacing;
    if (!slope || ratio < reach * (1 - same_spacing)) return std::nullopt;
    return Choice{last.method, spacing, last.cpu * std::pow(ratio, cost_slope(study, points)),
                  last.error * std::pow(ratio, *slope), Basis::extrapolated};
}

std::optional<Choice> choice_for(const Study& study, std::size_t quantity, std::size_t method, double target) {
    const Points points = points_of(study, method, quantity);
    if (points.empty()) return std::nullopt;
    std::size_t first = points.size();
    while (first > 0 && error_of(points[first - 1], quantity) <= target * (1 + same_error)) --first;
    if (first == points.size()) {
        const auto slope = error_slope(points, quantity);
        if (!slope) return std::nullopt;
        const Choice last = measured(points.back(), quantity);
        return beyond(study, quantity, points, last.spacing * std::pow(target / last.error, 1 / *slope));
    }
    const Choice fine = measured(points[first], quantity);
    if (first == 0 || !(fine.error > 0) || fine.error >= target) return fine;
    const Choice coarse = measured(points[first - 1], quantity);
    const double share = std::log(coarse.error / target) / std::log(coarse.error / fine.error);
    const Choice found = between(coarse, fine, share);
    return found.spacing < fine.spacing * (1 + same_spacing) ? fine : found;
}

double least_error(const Study& study, std::size_t quantity) {
    double least = std::numeric_limits<double>::infinity();
    for (const StudyPoint& p : study.points)
        if (p.state == PointState::done && p.error[quantity]) least = std::min(least, *p.error[quantity]);
    return least;
}

/// 1, 2, 3 or 5 times a power of ten, the next one above.
double round_up(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 3.0, 5.0})
        if (value <= digit * power * (1 + 1e-9)) return digit * power;  // 0.03 is not quite 3 · 0.01
    return 10 * power;
}

std::string with_unit(double value, const std::string& unit) {
    if (unit == "m") return length_text(value);
    return fmt::format("{:.3g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string limit_text(const Study& study, const Quantity& q, std::size_t quantity) {
    if (!q.uncertainty || !(*q.uncertainty > 0)) return "";
    const std::string whose = q.extrapolated ? "the extrapolation's" : "the reference's";
    std::string text = fmt::format(" Below {} ({}) {} own uncertainty hides any gain", percent_text(*q.uncertainty),
                                   with_unit(*q.uncertainty * q.scale, q.unit), whose);
    if (least_error(study, quantity) > *q.uncertainty) text += "; no run comes that near";
    return text + ".";
}

/// What other methods need for the same: the nearest ones, the rest as a number.
std::string others_text(const Study& study, const std::vector<Choice>& choices) {
    std::string text;
    for (std::size_t i = 1; i < std::min(choices.size(), 1 + most_named); ++i)
        text += fmt::format("{}{} {} ({} times)", i == 1 ? " Others: " : "; ", study.methods[choices[i].method],
                            seconds_text(choices[i].cpu), ratio_text(choices[i].cpu / choices.front().cpu));
    if (choices.size() > 1 + most_named) text += fmt::format("; {} more", choices.size() - 1 - most_named);
    return text.empty() ? text : text + ".";
}

std::string missed_text(const Study& study, const std::vector<Choice>& choices) {
    std::vector<std::string> missed;
    for (std::size_t m = 0; m < study.methods.size(); ++m)
        if (std::none_of(choices.begin(), choices.end(), [m](const Choice& c) { return c.method == m; }))
            missed.push_back(study.methods[m]);
    if (missed.empty()) return "";
    if (missed.size() > most_named) return fmt::format(" {} methods do not reach it.", missed.size());
    return fmt::format(" Not reached by: {}.", fmt::join(missed, "; "));
}

/// What half of an error costs; nothing where the truth's uncertainty would hide it.
std::string half_text(const Study& study, std::size_t quantity, double target) {
    if (target / 2 < study.quantities[quantity].uncertainty.value_or(0)) return "";
    const std::vector<Choice> now = choices_for(study, quantity, target);
    const std::vector<Choice> half = choices_for(study, quantity, target / 2);
    if (now.empty() || half.empty()) return "";
    if (half.front().basis == Basis::measured && half.front().cpu == now.front().cpu)
        return " The same run has half the error.";
    return fmt::format(" Half the error: {}, {} times the cost.", choice_text(study, half.front()),
                       ratio_text(half.front().cpu / now.front().cpu));
}

}  // namespace

std::vector<Choice> choices_for(const Study& study, std::size_t quantity, double target) {
    std::vector<Choice> choices;
    for (std::size_t m = 0; m < study.methods.size(); ++m)
        if (const auto choice = choice_for(study, quantity, m, target)) choices.push_back(*choice);
    std::stable_sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) { return a.cpu < b.cpu; });
    return choices;
}

std::optional<Choice> expected(const Study& study, std::size_t quantity, std::size_t method, double spacing) {
    const Points points = points_of(study, method, quantity);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::abs(points[i]->spacing / spacing - 1) < same_spacing) return measured(points[i], quantity);
        if (i == 0 || points[i]->spacing > spacing || points[i - 1]->spacing < spacing) continue;
        const Choice coarse = measured(points[i - 1], quantity), fine = measured(points[i], quantity);
        if (!(coarse.error > 0 && fine.error > 0)) return fine;
        return between(coarse, fine, std::log(coarse.spacing / spacing) / std::log(coarse.spacing / fine.spacing));
    }
    if (points.empty() || spacing > points.back()->spacing) return std::nullopt;
    return beyond(study, quantity, points, spacing);
}

std::optional<double> target_of(const Study& study, std::size_t quantity) {
    const double least = least_error(study, quantity);
    if (!std::isfinite(least)) return std::nullopt;
    const double wanted = std::max(2 * least, study.quantities[quantity].uncertainty.value_or(0));
    if (!(wanted > 0)) return std::nullopt;
    return round_up(wanted);
}

std::string choice_text(const Study& study, const Choice& choice) {
    const std::string basis = choice.basis == Basis::measured ? "" : fmt::format(" ({})", word_of(choice.basis));
    return fmt::format("spacing {}, {}: {} CPU-s{}", length_text(choice.spacing), study.methods[choice.method],
                       seconds_text(choice.cpu), basis);
}

std::string target_text(const Study& study, std::size_t quantity, double target) {
    const std::vector<Choice> choices = choices_for(study, quantity, target);
    const std::string& name = study.quantities[quantity].name;
    if (choices.empty())
        return fmt::format("For {} in {}: not reached; the best run has {}.", percent_text(target), name,
                           percent_text(least_error(study, quantity)));
    const std::string text =
        fmt::format("For {} in {}: {}.", percent_text(target), name, choice_text(study, choices.front()));
    return text + others_text(study, choices) + missed_text(study, choices);
}

std::vector<std::string> advice(const Study& study) {
    std::vector<std::string> lines;
    for (std::size_t q = 0; q < study.quantities.size(); ++q) {
        const auto target = target_of(study, q);
        const double hidden = study.quantities[q].uncertainty.value_or(0);
        if (!target || hidden >= 1) {
            const std::string why =
                !target ? "no run could be measured"
                        : fmt::format("its truth is known to {} only, nothing can be advised", percent_text(hidden));
            lines.push_back(fmt::format("{}: {}.", study.quantities[q].name, why));
            continue;
        }
        lines.push_back(target_text(study, q, *target) + half_text(study, q, *target) +
                        limit_text(study, study.quantities[q], q));
    }
    return lines;
}

std::string machine_text(const Study& study) {
    return fmt::format("{}, {} processors, {}", study.machine.processor, study.machine.processors,
                       study.machine.instruction_set);
}

}  // namespace sluice
