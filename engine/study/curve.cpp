#include "engine/study/curve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/scene/read/number_table.hpp"

namespace sluice {
namespace {

/// Vertex of the parabola through three points; the middle one if they lie on a line.
std::pair<double, double> vertex(const Curve& c, std::size_t i) {
    const double t = c.time[i], f = c.value[i];
    if (i == 0 || i + 1 == c.time.size()) return {t, f};
    const double left = c.time[i - 1] - t, right = c.time[i + 1] - t;
    const double slope_left = (c.value[i - 1] - f) / left, slope_right = (c.value[i + 1] - f) / right;
    const double curvature = (slope_right - slope_left) / (right - left);
    if (!(curvature < 0)) return {t, f};
    const double slope = slope_left - curvature * left;  // at the middle point
    const double shift = -slope / (2 * curvature);
    return {t + shift, f + slope * shift + curvature * shift * shift};
}

std::size_t highest(const Curve& c) {
    return static_cast<std::size_t>(std::max_element(c.value.begin(), c.value.end()) - c.value.begin());
}

/// Sum and number of the times between neighbouring passes through a level in one direction.
struct Intervals {
    double sum = 0;
    int count = 0;
};

Intervals intervals(const Curve& c, double level, double direction) {
    Intervals found;
    std::optional<double> before;
    for (std::size_t i = 1; i < c.time.size(); ++i) {
        const double low = direction * (c.value[i - 1] - level), high = direction * (c.value[i] - level);
        if (!(low < 0 && high >= 0)) continue;
        const double t = c.time[i - 1] + (c.time[i] - c.time[i - 1]) * low / (low - high);
        if (before) {
            found.sum += t - *before;
            ++found.count;
        }
        before = t;
    }
    return found;
}

std::optional<double> period(const Curve& c) {
    const auto [low, high] = std::minmax_element(c.value.begin(), c.value.end());
    const double middle = 0.5 * (*low + *high);
    const Intervals up = intervals(c, middle, 1), down = intervals(c, middle, -1);
    if (up.count + down.count == 0) return std::nullopt;
    return (up.sum + down.sum) / (up.count + down.count);
}

double mean(const Curve& c) {
    double sum = 0;
    for (std::size_t i = 1; i < c.time.size(); ++i)
        sum += 0.5 * (c.value[i] + c.value[i - 1]) * (c.time[i] - c.time[i - 1]);
    return sum / (c.time.back() - c.time.front());
}

}  // namespace

ProbeTable::ProbeTable(const std::filesystem::path& file) {
    NumberTable table = read_number_table(file);
    for (const std::string& heading : table.names) {
        const std::size_t unit = heading.find(" [");
        names_.push_back(heading.substr(0, unit));
        units_.push_back(unit == std::string::npos ? "" : heading.substr(unit + 2, heading.size() - unit - 3));
    }
    columns_ = std::move(table.columns);
}

Curve ProbeTable::curve(const std::string& column) const {
    const auto found = std::find(names_.begin(), names_.end(), column);
    if (found == names_.end()) return {};
    return {columns_[0], columns_[static_cast<std::size_t>(found - names_.begin())]};
}

std::string ProbeTable::unit(const std::string& column) const {
    const auto found = std::find(names_.begin(), names_.end(), column);
    return found == names_.end() ? "" : units_[static_cast<std::size_t>(found - names_.begin())];
}

Curve window(const Curve& curve, double from, const std::optional<double>& to) {
    // Times are multiples of a step, and sums of steps carry rounding; a billionth of the time is beyond it.
    const double end = curve.time.empty() ? 0 : curve.time.back(), slack = 1e-9 * end;
    Curve part;
    for (std::size_t i = 0; i < curve.time.size(); ++i) {
        if (curve.time[i] < from - slack || (to && curve.time[i] > *to + slack)) continue;
        part.time.push_back(curve.time[i]);
        part.value.push_back(curve.value[i]);
    }
    return part;
}

double value_at(const Curve& curve, double t) {
    const auto after = std::upper_bound(curve.time.begin(), curve.time.end(), t);
    if (after == curve.time.begin()) return curve.value.front();
    if (after == curve.time.end()) return curve.value.back();
    const auto i = static_cast<std::size_t>(after - curve.time.begin());
    const double part = (t - curve.time[i - 1]) / (curve.time[i] - curve.time[i - 1]);
    return curve.value[i - 1] + part * (curve.value[i] - curve.value[i - 1]);
}

std::optional<double> measure_of(const Curve& curve, Measure measure) {
    if (curve.time.size() < 2) return std::nullopt;
    switch (measure) {
        case Measure::peak:
            return vertex(curve, highest(curve)).second;
        case Measure::peak_time:
            return vertex(curve, highest(curve)).first;
        case Measure::period:
            return period(curve);
        case Measure::final:
            return curve.value.back();
        case Measure::mean:
            return mean(curve);
        case Measure::rms:
        case Measure::max:
            break;
    }
    throw std::logic_error("a measure of two curves asked of one");
}

std::optional<double> distance(const Curve& curve, const Curve& truth, Measure measure) {
    if (curve.time.empty()) return std::nullopt;
    double squares = 0, largest = 0;
    int count = 0;
    const double slack = 1e-9 * curve.time.back();  // as in window()
    for (std::size_t i = 0; i < truth.time.size(); ++i) {
        if (truth.time[i] < curve.time.front() - slack || truth.time[i] > curve.time.back() + slack) continue;
        const double difference = value_at(curve, truth.time[i]) - truth.value[i];
        squares += difference * difference;
        largest = std::max(largest, std::abs(difference));
        ++count;
    }
    if (count < 2) return std::nullopt;
    return measure == Measure::max ? largest : std::sqrt(squares / count);
}

}  // namespace sluice
