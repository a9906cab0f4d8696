#include "engine/study/extrapolation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sluice {
namespace {

// Below, differences shrink so slowly that the limit lies farther off than any run; above, no sum over neighbours
// converges that fast, and the three spacings are not of one series.
constexpr double least_order = 0.5, most_order = 4;
constexpr double searched_order = 12;  // to say by how much it is beyond
// Roache 1994: with three grids, and with two, where the order is not known.
constexpr double safety_of_three = 1.25, safety_of_two = 3;

using Values = std::vector<double>;

Values difference(const Values& a, const Values& b) {
    Values d(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
    return d;
}

double dot(const Values& a, const Values& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

double norm(const Values& a) { return std::sqrt(dot(a, a) / static_cast<double>(a.size())); }

/// p of the docstring's first formula, which grows with p; none outside (0, searched_order).
std::optional<double> observed_order(double d3, double d2, double d1, double wanted) {
    const auto ratio = [&](double p) {
        return (std::pow(d3, p) - std::pow(d2, p)) / (std::pow(d2, p) - std::pow(d1, p));
    };
    double low = 1e-3, high = searched_order;
    if (!(ratio(low) < wanted && wanted < ratio(high))) return std::nullopt;
    for (int i = 0; i < 60; ++i) {  // halvings: more than a double has bits
        const double middle = 0.5 * (low + high);
        (ratio(middle) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

Extrapolation finest(const Values& value, double uncertainty, const std::string& why) {
    return {value, uncertainty, std::nullopt, false, why};
}

}  // namespace

Extrapolation extrapolate(std::vector<SpacedResult> results) {
    if (results.size() < 2) throw std::logic_error("nothing to extrapolate from");
    std::sort(results.begin(), results.end(), [](const auto& a, const auto& b) { return a.spacing < b.spacing; });
    const SpacedResult &f1 = results[0], &f2 = results[1];
    const Values fine = difference(f1.value, f2.value);
    if (results.size() == 2)
        return finest(f1.value, safety_of_two * norm(fine),
                      "only two spacings: no order can be observed; the finest run stands for the truth");
    const SpacedResult& f3 = results[2];
    const Values coarse = difference(f2.value, f3.value);
    const double spread = std::max({norm(fine), norm(coarse), norm(difference(f1.value, f3.value))});
    if (!(norm(fine) > 0)) return finest(f1.value, 0, "the two finest runs agree in all digits");
    if (!(dot(fine, coarse) > 0))
        return finest(f1.value, spread,
                      "no credible order: the differences of the three finest runs change sign; the finest stands for "
                      "the truth, their spread for its uncertainty");
    const auto order = observed_order(f3.spacing, f2.spacing, f1.spacing, norm(coarse) / norm(fine));
    if (!order || *order < least_order || *order > most_order) {
        const std::string found = order ? fmt::format("of {:.2g} observed", *order) : "fits the three finest runs";
        Extrapolation result = finest(
            f1.value, spread,
            fmt::format("no credible order ({} {}, {} to {} would be); the finest run stands for the truth, the spread "
                        "of three for its uncertainty",
                        order ? "one" : "none", found, least_order, most_order));
        result.order = order;
        return result;
    }
    const double share = std::pow(f1.spacing, *order) / (std::pow(f2.spacing, *order) - std::pow(f1.spacing, *order));
    Extrapolation result{f1.value, safety_of_three * share * norm(fine), order, true, ""};
    for (std::size_t i = 0; i < fine.size(); ++i) result.value[i] += share * fine[i];
    result.note = fmt::format("extrapolated from the three finest runs, observed order {:.2f}", *order);
    return result;
}

}  // namespace sluice
