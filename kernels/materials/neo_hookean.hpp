#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/materials/strain.hpp"

namespace sluice {

/// Compressible neo-Hookean law [Bonet & Wood 2008, chapter 6], with J = det F:
///   ψ = μ/2 (tr(FᵀF) − 3) + g(J),   P = μ F + g'(J) cof F,   g(J) = −μ ln J + λ/2 (ln J)²
/// which is P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ, as cof F = J F⁻ᵀ. Where a particle is compressed to less than J0 = 0.3, g
/// goes on as its second-order expansion at J0: energy and stress stay continuous, finite for J ≤ 0 too, and push the
/// particle back from being inverted; g'' stays what it is at J0, so that a time step that was stable there stays so.
struct NeoHookean {
    double lambda = 0, mu = 0;  ///< Lamé's constants [Pa]

    /// J0: more compression than rubber bears in water. g'' is already some twenty times that of J = 1 there.
    static constexpr double expansion_volume = 0.3;

    template <int Dim>
    double energy_density(const Tensor<Dim>& f) const {
        const Tensor<Dim> h = f - Tensor<Dim>::Identity(), e = green_strain<Dim>(h);
        // ln J from the strain too, not from J: ψ ~ |E|² then has the strain's digits, whatever the rotation.
        return mu * e.trace() + volume_energy(volume_change<Dim>(h), 0.5 * std::log1p(volume_change<Dim>(2 * e)));
    }
    template <int Dim>
    Tensor<Dim> first_piola_stress(const Tensor<Dim>& f) const {
        return mu * f + volume_stress(volume_change<Dim>(f - Tensor<Dim>::Identity())) * cofactor(f);
    }

  private:
    /// g(J), of J − 1 and ln J.
    double volume_energy(double change, double log_j) const {
        constexpr double lowest = expansion_volume - 1;
        const double below = std::min(change - lowest, 0.0);
        if (below < 0) log_j = std::log(expansion_volume);
        return (0.5 * lambda * log_j - mu) * log_j +
               (volume_stress(lowest) + 0.5 * expansion_stiffness() * below) * below;
    }
    /// g'(J), of J − 1.
    double volume_stress(double change) const {
        constexpr double lowest = expansion_volume - 1;
        const double from = std::max(change, lowest);
        return (lambda * std::log1p(from) - mu) / (1 + from) + expansion_stiffness() * std::min(change - lowest, 0.0);
    }
    /// g''(J0)
    double expansion_stiffness() const {
        return (lambda + mu - lambda * std::log(expansion_volume)) / (expansion_volume * expansion_volume);
    }
};

}  // namespace sluice
