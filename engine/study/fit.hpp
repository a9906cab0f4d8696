// What is read from a cloud of costs and errors: slopes and the Pareto front.
#pragma once

#include <optional>
#include <vector>

namespace sluice {

/// y ≈ factor · x^exponent
struct PowerFit {
    double exponent = 0;
    double factor = 0;
    std::optional<double> uncertainty;  ///< standard error of the exponent; none with two points
};

/// Least squares in logarithms; none for fewer than two different x or values that are not positive.
std::optional<PowerFit> fit_power(const std::vector<double>& x, const std::vector<double>& y);

struct CostAndError {
    double cost = 0;
    double error = 0;
};

/// Indices of those that no other beats in one without losing in the other, by rising cost. An error within 1 % of
/// another's is no better: nobody would pay for it.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

}  // namespace sluice
