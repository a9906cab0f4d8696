#pragma once

namespace sluice {

/// Momentum handed from fluid to solid in the last step [N], and what is left when both sides are added up.
struct InterfaceBalance {
    double force = 0;     ///< sum of the magnitudes of the forces of elements or particles
    double residual = 0;  ///< worst so far: |force on solid + force on fluid + reaction of the mirror walls| / force
};

}  // namespace sluice
