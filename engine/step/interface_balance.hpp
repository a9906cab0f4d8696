// How well the forces between fluid and solid cancel.
#pragma once

#include <algorithm>

namespace sluice {

/// Momentum exchanged per time [N; N/m in 2D], and the residual when both sides are added up.
struct InterfaceBalance {
    double force = 0;     ///< sum of the magnitudes of the forces of elements or particles, in the last step
    double largest = 0;   ///< the largest of these sums so far
    double residual = 0;  ///< worst so far: |force on solid + force on fluid + reaction of the mirror walls| / largest

    /// The residual is relative to the largest force so far: in a step in which the two hardly touch, both are
    /// rounding, as the pressure of a pair, 2 p + ρ (g − a)·x, is a difference that each side rounds by itself.
    void record(double magnitude, double net) {
        force = magnitude;
        largest = std::max(largest, magnitude);
        if (largest > 0) residual = std::max(residual, net / largest);
    }

    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("force", force), visit("largest", largest), visit("residual", residual);
    }
};

}  // namespace sluice
