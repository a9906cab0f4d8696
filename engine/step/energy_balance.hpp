#pragma once

namespace sluice {

/// The energy of all moving particles, by form. [J; J/m in 2D]
struct EnergyBalance {
    double kinetic = 0;
    double potential = 0;
    double compression = 0;  ///< of fluid and hypoelastic solid: ∫ p/ρ² dρ
    double elastic = 0;      ///< of the hypoelastic solid's deviatoric stress, S:S/4μ; of the total-Lagrangian one all
    double contact = 0;      ///< of solids pressed against each other or against walls
    double total() const { return kinetic + potential + compression + elastic + contact; }
};

}  // namespace sluice
