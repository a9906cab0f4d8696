#include "engine/study/truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/scene/formula.hpp"
#include "engine/scene/probe_columns.hpp"

namespace sluice {
namespace {

/// Fine enough that the largest value of a formula is found within 1e-5 if it has less than a hundred turns.
constexpr int formula_samples = 20001;

Curve sampled(const Scene& scene, const Reference& reference, std::vector<double> times) {
    const CompiledFormula formula(scene, "reference." + reference.name + ".formula", reference.formula, Variable::time);
    Curve curve{std::move(times), {}};
    for (const double t : curve.time) curve.value.push_back(formula(t));
    return curve;
}

/// The reference as a curve: its table, or its formula at `times`.
Curve truth_curve(const Scene& scene, const Reference& reference, const std::vector<double>& times) {
    if (reference.formula.empty()) return window({reference.time, reference.value}, reference.from, reference.to);
    return sampled(scene, reference, times);
}

double largest(const Curve& curve) {
    double size = 0;
    for (const double value : curve.value) size = std::max(size, std::abs(value));
    return size;
}

Reference implied(const std::string& column) {
    Reference reference;
    reference.name = reference.column = column;
    return reference;
}

}  // namespace

std::vector<Reference> references_of(const Scene& scene) {
    std::vector<Reference> all = scene.references;
    const auto has = [&](const std::string& column) {
        return std::any_of(all.begin(), all.end(), [&](const Reference& r) { return r.column == column; });
    };
    for (const Probe& probe : scene.probes)
        for (const std::string& column : probe_columns(probe, scene.dimension))
            if (probe.has_place() && !has(column)) all.push_back(implied(column));
    for (const Probe& probe : scene.probes)
        if (all.empty() && probe.kind == ProbeKind::energy) all.push_back(implied(probe.name + ".kinetic"));
    return all;
}

std::optional<double> stated_error(const Scene& scene, const Reference& reference, const Curve& run) {
    const Curve part = window(run, reference.from, reference.to);
    if (part.time.size() < 2) return std::nullopt;
    if (is_pointwise(reference.measure))
        return distance(run, truth_curve(scene, reference, part.time), reference.measure);
    const std::optional<double> found = measure_of(part, reference.measure);
    const std::optional<double> wanted =
        reference.number ? reference.number : measure_of(truth_curve(scene, reference, part.time), reference.measure);
    if (!found || !wanted) return std::nullopt;
    return std::abs(*found - *wanted);
}

double scale_of(const Scene& scene, const Reference& reference) {
    if (reference.scale) return *reference.scale;
    const std::string key = "reference." + reference.name;
    double size = 0;
    if (reference.number) {
        size = std::abs(*reference.number);
    } else {
        const double end = reference.to.value_or(scene.output.end);
        std::vector<double> times(formula_samples);
        for (int i = 0; i < formula_samples; ++i)
            times[static_cast<std::size_t>(i)] =
                reference.from + (end - reference.from) * static_cast<double>(i) / (formula_samples - 1);
        const Curve curve = truth_curve(scene, reference, times);
        if (curve.time.size() < 2)
            scene.fail(key, "found fewer than two rows from `from` to `to`, expected two or more");
        if (is_pointwise(reference.measure)) {
            size = largest(curve);
        } else {
            const std::optional<double> value = measure_of(curve, reference.measure);
            if (!value) scene.fail(key, "found a reference without a period, expected two passes in one direction");
            size = std::abs(*value);
        }
    }
    if (!(size > 0))
        scene.fail(key, "found a reference of 0 without a scale, expected the scale that relative errors refer to");
    return size;
}

std::string meaning_of(const Reference& reference) {
    std::string text = fmt::format("{} of {}", long_name_of(reference.measure), reference.column);
    const char* from = is_pointwise(reference.measure) ? "from" : "against";
    if (reference.number)
        text += fmt::format(" {} {:.6g}", from, *reference.number);
    else if (reference.formula.find('t') == std::string::npos && !reference.formula.empty())
        text += fmt::format(" {} {}", from, reference.formula);  // no function of time
    else if (!reference.formula.empty())
        text += fmt::format(" {} the exact solution", from);
    else if (!reference.time.empty())
        text += fmt::format(" {} {}", from, reference.table_file);
    else
        text += fmt::format(" {} the finest runs", from);
    if (reference.to)
        text += fmt::format(", {:.6g} to {:.6g} s", reference.from, *reference.to);
    else if (reference.from > 0)
        text += fmt::format(", from {:.6g} s on", reference.from);
    return text;
}

}  // namespace sluice
