// Hyperelastic material laws: energy density and first Piola-Kirchhoff stress of a deformation gradient F = ∂x/∂X.
//
// In 2D the strain is plane: F_zz = 1, and the sums over components lose nothing by leaving z out.
#pragma once

#include <cmath>

#include "kernels/choices.hpp"
#include "kernels/materials/neo_hookean.hpp"
#include "kernels/materials/saint_venant_kirchhoff.hpp"

namespace sluice {

/// An isotropic elastic material, by one of the laws of kernels/elastic_laws.def; all are Hooke's at small strains.
struct Hyperelastic {
    ElasticLaw law = ElasticLaw::saint_venant_kirchhoff;
    double lambda = 0, mu = 0;  ///< Lamé's constants [Pa]

    /// The fluid sees no solid denser than this J makes it, whatever its law.
    static constexpr double expansion_volume = NeoHookean::expansion_volume;

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
        return of_law<double>([&](const auto& formulas) { return formulas.template energy_density<Dim>(f); });
    }
    /// P = ∂ψ/∂F [Pa]
    template <int Dim>
    Tensor<Dim> first_piola_stress(const Tensor<Dim>& f) const {
        return of_law<Tensor<Dim>>([&](const auto& formulas) { return formulas.template first_piola_stress<Dim>(f); });
    }

  private:
    /// value(formulas) of the law.
    template <class T, class Value>
    T of_law(const Value& value) const {
        switch (law) {
#define SLUICE_ELASTIC_LAW(law, Formulas, word) \
    case ElasticLaw::law:                       \
        return value(Formulas{lambda, mu});
#include "kernels/elastic_laws.def"
#undef SLUICE_ELASTIC_LAW
        }
        return T();
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
