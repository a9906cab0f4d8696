#include "engine/study/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/study/extrapolation.hpp"
#include "engine/study/truth.hpp"

namespace sluice {
namespace {

using Tables = std::vector<std::optional<ProbeTable>>;

/// A point's result for a reference that states no truth: its number, or its curve at `times`. Empty if there is none.
std::vector<double> result_of(const Curve& curve, const Reference& reference, const std::vector<double>& times) {
    if (!is_pointwise(reference.measure)) {
        const auto number = measure_of(window(curve, reference.from, reference.to), reference.measure);
        return number ? std::vector<double>{*number} : std::vector<double>{};
    }
    std::vector<double> values;
    if (curve.time.size() >= 2)
        for (const double t : times) values.push_back(value_at(curve, t));
    return values;
}

/// Results of all points; curves at the times of the finest run, as each run steps at its own times.
std::vector<std::vector<double>> results_of(const Study& study, const Reference& reference, const Tables& tables) {
    std::size_t finest = study.points.size();
    for (std::size_t i = 0; i < study.points.size(); ++i)
        if (tables[i] && (finest == study.points.size() || study.points[i].spacing < study.points[finest].spacing))
            finest = i;
    std::vector<std::vector<double>> results(study.points.size());
    if (finest == study.points.size()) return results;
    const std::vector<double> times =
        window(tables[finest]->curve(reference.column), reference.from, reference.to).time;
    for (std::size_t i = 0; i < study.points.size(); ++i)
        if (tables[i]) results[i] = result_of(tables[i]->curve(reference.column), reference, times);
    return results;
}

struct BestKnown {
    double spacing = 0;  ///< finest that it comes from [m]
    std::string method;
    Extrapolation limit;
};

/// The limit of the method with the finest run; among equals a credible one, then the one with the least uncertainty.
std::optional<BestKnown> best_known(const Study& study, const std::vector<std::vector<double>>& results) {
    std::optional<BestKnown> best;
    for (std::size_t m = 0; m < study.methods.size(); ++m) {
        std::vector<SpacedResult> series;
        for (std::size_t i = 0; i < results.size(); ++i)
            if (study.points[i].method == m && !results[i].empty())
                series.push_back({study.points[i].spacing, results[i]});
        if (series.size() < 2) continue;
        const double finest = std::min_element(series.begin(), series.end(), [](const auto& a, const auto& b) {
                                  return a.spacing < b.spacing;
                              })->spacing;
        BestKnown found{finest, study.methods[m], extrapolate(std::move(series))};
        const auto rank = [](const BestKnown& k) {
            return std::tuple(k.spacing, !k.limit.is_credible, k.limit.uncertainty);
        };
        if (!best || rank(found) < rank(*best)) best = std::move(found);
    }
    return best;
}

/// An error that is not finite is none: a run may have written such a value and gone on.
void add_error(StudyPoint& point, const std::optional<double>& error) {
    point.error.push_back(error && std::isfinite(*error) ? error : std::nullopt);
}

double size_of(const std::vector<double>& values) {
    double size = 0;
    for (const double value : values) size = std::max(size, std::abs(value));
    return size;
}

/// As distance() of curves: root of the mean square, or largest.
double distance_of(const std::vector<double>& a, const std::vector<double>& b, Measure measure) {
    double squares = 0, largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        squares += (a[i] - b[i]) * (a[i] - b[i]);
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return measure == Measure::max ? largest : std::sqrt(squares / static_cast<double>(a.size()));
}

void add_unstated(Study& study, Quantity quantity, const Reference& reference, const Tables& tables) {
    const auto results = results_of(study, reference, tables);
    const auto best = best_known(study, results);
    quantity.extrapolated = true;
    if (best) {
        quantity.scale = reference.scale.value_or(size_of(best->limit.value));
        quantity.note = best->method + ": " + best->limit.note;
        if (study.methods.size() > 1) quantity.note += "; other methods' distance from this one counts as their error";
        if (quantity.scale > 0) quantity.uncertainty = best->limit.uncertainty / quantity.scale;
    } else {
        quantity.note = "no method has two runs that could be compared";
    }
    // A run that itself stands for the truth, and its like in other precision, would seem to have no error.
    const double truth_spacing = best && !best->limit.is_credible ? best->spacing : 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        std::optional<double> error;
        if (best && quantity.scale > 0 && !results[i].empty() && study.points[i].spacing > truth_spacing)
            error = distance_of(results[i], best->limit.value, reference.measure) / quantity.scale;
        add_error(study.points[i], error);
    }
    study.quantities.push_back(std::move(quantity));
}

void add_stated(Study& study, const Scene& scene, Quantity quantity, const Reference& reference, const Tables& tables) {
    quantity.scale = scale_of(scene, reference);
    if (reference.uncertainty) quantity.uncertainty = *reference.uncertainty / quantity.scale;
    quantity.note = reference.source;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        std::optional<double> error;
        if (tables[i]) error = stated_error(scene, reference, tables[i]->curve(reference.column));
        if (error) *error /= quantity.scale;
        add_error(study.points[i], error);
    }
    study.quantities.push_back(std::move(quantity));
}

std::string unit_of(const Reference& reference, const Tables& tables) {
    switch (reference.measure) {
        case Measure::period:
        case Measure::peak_time:
            return "s";
        case Measure::rms:
        case Measure::max:
        case Measure::peak:
        case Measure::final:
        case Measure::mean:
            break;
    }
    for (const auto& table : tables)
        if (table) return table->unit(reference.column);
    return "";
}

}  // namespace

void measure_errors(Study& study, const Scene& scene, const std::vector<std::optional<ProbeTable>>& curves) {
    study.quantities.clear();
    for (StudyPoint& point : study.points) point.error.clear();
    for (const Reference& reference : references_of(scene)) {
        Quantity quantity;
        quantity.name = reference.name;
        quantity.meaning = meaning_of(reference);
        quantity.unit = unit_of(reference, curves);
        if (reference.is_stated())
            add_stated(study, scene, std::move(quantity), reference, curves);
        else
            add_unstated(study, std::move(quantity), reference, curves);
    }
}

}  // namespace sluice
