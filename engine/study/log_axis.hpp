// A logarithmic axis: where values go, and at which of them stands a mark.
#pragma once

#include <vector>

namespace sluice {

class LogAxis {
  public:
    /// Values from `low` to `high`, both > 0, drawn from pixel `start` to `end`; widened until two labelled marks or
    /// more lie inside.
    LogAxis(double low, double high, double start, double end);

    double operator()(double value) const;
    double low() const { return low_; }
    double high() const { return high_; }

    /// With a number: 1, 2 and 5 times powers of ten; powers alone where those would crowd.
    std::vector<double> labelled() const;
    /// With a line only: the whole multiples of powers of ten.
    std::vector<double> fine() const;

  private:
    std::vector<double> multiples(const std::vector<double>& digits) const;

    double low_, high_, start_, end_;
};

}  // namespace sluice
