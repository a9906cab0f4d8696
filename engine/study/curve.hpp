// A measured quantity over time, and the numbers that are read from it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/reference.hpp"

namespace sluice {

struct Curve {
    std::vector<double> time;  ///< rising [s]
    std::vector<double> value;
};

/// The columns of a probes.csv by their names without units. Throws std::runtime_error.
class ProbeTable {
  public:
    explicit ProbeTable(const std::filesystem::path& file);

    /// Empty if there is no such column.
    Curve curve(const std::string& column) const;
    std::string unit(const std::string& column) const;

  private:
    std::vector<std::string> names_, units_;
    std::vector<std::vector<double>> columns_;
};

/// What lies within [from, to]; no end = all that follows.
Curve window(const Curve& curve, double from, const std::optional<double>& to);

/// By straight lines between the points; t must lie within the curve.
double value_at(const Curve& curve, double t);

/// A number that a curve has; none if it has not: no period without two passes, nothing of fewer than two points.
///   peak       largest value, of the parabola through the three highest points
///   peak_time  when it has that
///   period     mean time between passes in the same direction through the middle of its extremes
///   final      last value
///   mean       over time, by the trapezoidal rule
/// Throws std::logic_error for measures of two curves.
std::optional<double> measure_of(const Curve& curve, Measure measure);

/// Distance of two curves at the times of `truth` that `curve` covers: root of the mean square, or largest. None with
/// fewer than two such times.
std::optional<double> distance(const Curve& curve, const Curve& truth, Measure measure);

}  // namespace sluice
