#include "engine/study/log_axis.hpp"

#include <cmath>

namespace sluice {
namespace {

/// Over more than this, numbers at 1, 2 and 5 crowd.
constexpr double most_decades_in_detail = 2.6;
constexpr double widening = 1.3;

}  // namespace

LogAxis::LogAxis(double low, double high, double start, double end) : low_(low), high_(high), start_(start), end_(end) {
    while (labelled().size() < 2) {
        low_ /= widening;
        high_ *= widening;
    }
}

double LogAxis::operator()(double value) const {
    return start_ + (end_ - start_) * std::log(value / low_) / std::log(high_ / low_);
}

std::vector<double> LogAxis::labelled() const {
    if (std::log10(high_ / low_) > most_decades_in_detail) return multiples({1});
    return multiples({1, 2, 5});
}

std::vector<double> LogAxis::fine() const { return multiples({1, 2, 3, 4, 5, 6, 7, 8, 9}); }

std::vector<double> LogAxis::multiples(const std::vector<double>& digits) const {
    std::vector<double> values;
    for (int power = static_cast<int>(std::floor(std::log10(low_))); power <= std::log10(high_); ++power)
        for (const double digit : digits) {
            const double value = digit * std::pow(10, power);
            if (value >= low_ * (1 - 1e-9) && value <= high_ * (1 + 1e-9)) values.push_back(value);  // rounding of pow
        }
    return values;
}

}  // namespace sluice
