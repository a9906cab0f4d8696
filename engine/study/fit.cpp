#include "engine/study/fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sluice {
namespace {

constexpr double worth_paying = 0.99;

}  // namespace

std::optional<PowerFit> fit_power(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!(x[i] > 0 && y[i] > 0)) return std::nullopt;
        mean_x += std::log(x[i]) / n;
        mean_y += std::log(y[i]) / n;
    }
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = std::log(x[i]) - mean_x;
        xx += dx * dx;
        xy += dx * (std::log(y[i]) - mean_y);
    }
    if (!(xx > 0)) return std::nullopt;
    PowerFit fit{xy / xx, std::exp(mean_y - xy / xx * mean_x), std::nullopt};
    if (x.size() < 3) return fit;
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double rest = std::log(y[i] / fit.factor) - fit.exponent * std::log(x[i]);
        squares += rest * rest;
    }
    fit.uncertainty = std::sqrt(squares / (n - 2) / xx);
    return fit;
}

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || points[i].error < worth_paying * points[front.back()].error) front.push_back(i);
    return front;
}

}  // namespace sluice
