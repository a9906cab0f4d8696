#pragma once

#include <cmath>

namespace sluice {

/// Tait's equation of state [Monaghan 1994], p = ρ0 c0²/γ ((ρ/ρ0)^γ − 1). With γ = 1 it is the linear one of both media
/// [Antoci2007, eq. 4], p = c0² (ρ − ρ0).
///
/// Near ρ0, where a weakly compressible fluid stays, (ρ/ρ0)^γ and 1 cancel: everything is written with ρ − ρ0.
struct EquationOfState {
    double density = 0;      ///< ρ0 [kg/m³]
    double sound_speed = 0;  ///< c0 [m/s]
    double exponent = 1;     ///< γ

    /// Water has γ = 7 [Monaghan 1994].
    static EquationOfState tait(double density, double sound_speed, double exponent = 7) {
        return {density, sound_speed, exponent};
    }

    /// [Pa]
    double pressure(double rho) const {
        const double linear = sound_speed * sound_speed * (rho - density);
        if (exponent == 1) return linear;
        if (exponent == 7) {  // x⁷ − 1 = (x − 1) (1 + x + … + x⁶)
            const double x = rho / density, x2 = x * x;
            return linear * (1 + (x + x2) * (1 + x2 + x2 * x2)) / 7;
        }
        return stiffness() * std::expm1(exponent * std::log1p(compression(rho)));
    }
    /// The density at which the pressure is p > −ρ0 c0²/γ. [kg/m³]
    double density_at(double p) const {
        if (exponent == 1) return density + p / (sound_speed * sound_speed);
        return density + density * std::expm1(std::log1p(p / stiffness()) / exponent);
    }
    /// Work of compression per mass, ∫ p/ρ² dρ from ρ0. With x = ρ/ρ0 it is [J/kg]
    ///   c0²/γ ((x^(γ−1) − 1)/(γ − 1) + 1/x − 1),   for γ = 1: c0² (ln x + 1/x − 1)
    double energy(double rho) const {
        const double e = compression(rho), power = exponent - 1;
        const double work = power == 0 ? std::log1p(e) : std::expm1(power * std::log1p(e)) / power;
        return sound_speed * sound_speed / exponent * (work - e / (1 + e));
    }
    /// c = (dp/dρ)^½ = c0 (ρ/ρ0)^((γ−1)/2) [m/s]
    double sound_speed_at(double rho) const {
        const double x = rho / density;
        if (exponent == 7) return sound_speed * (x * x * x);
        return sound_speed * std::pow(x, 0.5 * (exponent - 1));
    }

  private:
    double compression(double rho) const { return (rho - density) / density; }
    /// ρ0 c0²/γ [Pa]
    double stiffness() const { return density * sound_speed * sound_speed / exponent; }
};

using LinearEquationOfState = EquationOfState;

}  // namespace sluice
