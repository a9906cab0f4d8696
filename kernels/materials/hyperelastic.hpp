// Hyperelastic material laws: energy density and first Piola-Kirchhoff stress of a deformation gradient F = ∂x/∂X.
//
// In 2D the strain is plane: F_zz = 1, and the sums over components lose nothing by leaving z out.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/choices.hpp"
#include "kernels/tensor.hpp"

namespace sluice {

/// det(F) F⁻ᵀ = ∂ det(F)/∂F, without a division: finite for every F.
inline Tensor<2> cofactor(const Tensor<2>& f) {
    Tensor<2> c;
    c << f(1, 1), -f(1, 0), -f(0, 1), f(0, 0);
    return c;
}
inline Tensor<3> cofactor(const Tensor<3>& f) {
    Tensor<3> c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            c(i, j) = f(i1, j1) * f(i2, j2) - f(i1, j2) * f(i2, j1);
        }
    return c;
}

/// det(I + H) − 1 by the invariants of H: no digits are lost at small strains.
template <int Dim>
double volume_change(const Tensor<Dim>& h) {
    if constexpr (Dim == 2)
        return h.trace() + h.determinant();
    else
        return h.trace() + cofactor(h).trace() + h.determinant();
}

/// An isotropic elastic material [Bonet & Wood 2008, chapter 6]. All laws are Hooke's at small strains.
///
/// St. Venant-Kirchhoff, with E = (FᵀF − I)/2, for small strains and any rotation: it softens under compression and
/// does not resist being turned inside out.
///   ψ = λ/2 tr(E)² + μ E:E,   P = F (λ tr(E) I + 2μ E)
/// Compressible neo-Hookean, with J = det F:
///   ψ = μ/2 (tr(FᵀF) − 3) + g(J),   P = μ F + g'(J) cof F,   g(J) = −μ ln J + λ/2 (ln J)²
/// which is P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ, as cof F = J F⁻ᵀ. Where a particle is compressed to less than J0 = 0.3, g
/// goes on as its second-order expansion at J0: energy and stress stay continuous, finite for J ≤ 0 too, and push the
/// particle back from being inverted; g'' stays what it is at J0, so that a time step that was stable there stays so.
struct Hyperelastic {
    ElasticLaw law = ElasticLaw::saint_venant_kirchhoff;
    double lambda = 0, mu = 0;  ///< Lamé's constants [Pa]

    /// J0: more compression than rubber bears in water. g'' is already some twenty times that of J = 1 there.
    static constexpr double expansion_volume = 0.3;

    /// From Young's modulus [Pa] and Poisson's ratio, −1 < ν < ½.
    static Hyperelastic with(ElasticLaw law, double young_modulus, double poisson_ratio) {
        const double mu = young_modulus / (2 * (1 + poisson_ratio));
        return {law, 2 * mu * poisson_ratio / (1 - 2 * poisson_ratio), mu};
    }
    /// E [Pa]
    double young_modulus() const { return mu * (3 * lambda + 2 * mu) / (lambda + mu); }
    /// λ + 2μ, of the fastest waves. [Pa]
    double wave_modulus() const { return lambda + 2 * mu; }

    /// ψ(F) per reference volume [J/m³]
    template <int Dim>
    double energy_density(const Tensor<Dim>& f) const {
        const Tensor<Dim> h = f - Tensor<Dim>::Identity(), e = green_strain<Dim>(h);
        switch (law) {
            case ElasticLaw::saint_venant_kirchhoff:
                return 0.5 * lambda * e.trace() * e.trace() + mu * e.squaredNorm();
            case ElasticLaw::neo_hookean:
                // ln J from the strain too, not from J: ψ ~ |E|² then has the strain's digits, whatever the rotation.
                return mu * e.trace() +
                       volume_energy(volume_change<Dim>(h), 0.5 * std::log1p(volume_change<Dim>(2 * e)));
        }
        __builtin_unreachable();
    }
    /// P = ∂ψ/∂F [Pa]
    template <int Dim>
    Tensor<Dim> first_piola_stress(const Tensor<Dim>& f) const {
        const Tensor<Dim> h = f - Tensor<Dim>::Identity();
        switch (law) {
            case ElasticLaw::saint_venant_kirchhoff: {
                const Tensor<Dim> e = green_strain<Dim>(h);
                return f * (lambda * e.trace() * Tensor<Dim>::Identity() + 2 * mu * e);
            }
            case ElasticLaw::neo_hookean:
                return mu * f + volume_stress(volume_change<Dim>(h)) * cofactor(f);
        }
        __builtin_unreachable();
    }

  private:
    /// E = (FᵀF − I)/2 of H = F − I.
    template <int Dim>
    static Tensor<Dim> green_strain(const Tensor<Dim>& h) {
        return 0.5 * (h + h.transpose() + h.transpose() * h);
    }
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

/// Cauchy stress σ = P Fᵀ/J; in 2D with the stress out of the plane, σ_zz. It has no meaning for a particle turned
/// inside out (J ≤ 0), which gets zero.
template <int Dim>
Tensor<3> cauchy_stress(const Hyperelastic& law, const Tensor<Dim>& f) {
    Tensor<3> full = Tensor<3>::Identity();
    full.template topLeftCorner<Dim, Dim>() = f;
    const double j = full.determinant();
    if (j <= 0) return Tensor<3>::Zero();
    return law.first_piola_stress<3>(full) * full.transpose() / j;
}

/// Von Mises' equivalent stress, √(3/2 S:S) of the deviator S. [Pa]
inline double von_mises_stress(const Tensor<3>& cauchy) {
    const Tensor<3> s = cauchy - cauchy.trace() / 3 * Tensor<3>::Identity();
    return std::sqrt(1.5 * s.squaredNorm());
}

}  // namespace sluice
