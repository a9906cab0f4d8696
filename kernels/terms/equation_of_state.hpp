#pragma once

#include <cmath>

namespace sluice {

/// Linear equation of state of both media [Antoci2007, eq. 4]: p = c0² (ρ − ρ0).
struct LinearEquationOfState {
    double density = 0;      ///< ρ0 [kg/m³]
    double sound_speed = 0;  ///< c0 [m/s]

    /// [Pa]
    double pressure(double rho) const { return sound_speed * sound_speed * (rho - density); }
    /// The density at which the pressure is p. [kg/m³]
    double density_at(double p) const { return density + p / (sound_speed * sound_speed); }
    /// Work of compression per mass, ∫ p/ρ² dρ from ρ0 = c0² (ln(ρ/ρ0) + ρ0/ρ − 1). [J/kg]
    double energy(double rho) const {
        const double x = (rho - density) / density;
        return sound_speed * sound_speed * (std::log1p(x) - x / (1 + x));
    }
};

}  // namespace sluice
