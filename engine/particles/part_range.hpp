// The particles of a part: a range of a set.
#pragma once

#include "neighbor/parallel.hpp"

namespace sluice {

/// Solids of different models share one set; each model has a range of its own.
struct PartRange {
    std::size_t first = 0, last = 0;

    std::size_t size() const { return last - first; }
    bool empty() const { return first == last; }
    bool holds(std::size_t i) const { return i >= first && i < last; }
};

/// body(i) for every particle of the range, a few operations each.
template <class Body>
void parallel_for(const PartRange& range, Body&& body) {
    const std::size_t first = range.first;
    parallel_for(range.size(), [first, &body](std::size_t k) { body(first + k); });
}
template <class F>
double nonnegative_max(const PartRange& range, F&& f) {
    const std::size_t first = range.first;
    return nonnegative_max(range.size(), [first, &f](std::size_t k) { return f(first + k); });
}
template <class T, class F>
T ordered_sum(const PartRange& range, F&& f) {
    const std::size_t first = range.first;
    return ordered_sum<T>(range.size(), [first, &f](std::size_t k) { return f(first + k); });
}

}  // namespace sluice
