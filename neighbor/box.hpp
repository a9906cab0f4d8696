// The smallest box around some points.
#pragma once

#include <limits>

#include "neighbor/vec.hpp"

namespace sluice {

template <int Dim>
struct Box {
    Vec<Dim> lo, hi;

    /// Around nothing: at an infinite distance from everything.
    Box() {
        unroll<Dim>([&](int k) {
            lo[k] = std::numeric_limits<double>::infinity();
            hi[k] = -std::numeric_limits<double>::infinity();
        });
    }
    Box(const Vec<Dim>& a, const Vec<Dim>& b) : lo(a), hi(b) {}

    void add(const Vec<Dim>& x) { add(Box(x, x)); }
    void add(const Box& b) {
        unroll<Dim>([&](int k) {
            lo[k] = b.lo[k] < lo[k] ? b.lo[k] : lo[k];
            hi[k] = b.hi[k] > hi[k] ? b.hi[k] : hi[k];
        });
    }
};

/// Squared distance between two boxes; 0 if they touch.
template <int Dim>
double distance2(const Box<Dim>& a, const Box<Dim>& b) {
    double d2 = 0;
    unroll<Dim>([&](int k) {
        const double gap = larger(larger(a.lo[k] - b.hi[k], b.lo[k] - a.hi[k]), 0.0);
        d2 += gap * gap;
    });
    return d2;
}

}  // namespace sluice
