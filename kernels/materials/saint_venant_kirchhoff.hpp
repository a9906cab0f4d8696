#pragma once

#include "kernels/materials/strain.hpp"

namespace sluice {

/// St. Venant-Kirchhoff's law [Bonet & Wood 2008, chapter 6], with E = (FᵀF − I)/2, for small strains and any rotation:
/// it softens under compression and does not resist being turned inside out.
///   ψ = λ/2 tr(E)² + μ E:E,   P = F (λ tr(E) I + 2μ E)
struct SaintVenantKirchhoff {
    double lambda = 0, mu = 0;  ///< Lamé's constants [Pa]

    template <int Dim>
    double energy_density(const Tensor<Dim>& f) const {
        const Tensor<Dim> e = green_strain<Dim>(f - Tensor<Dim>::Identity());
        return 0.5 * lambda * e.trace() * e.trace() + mu * e.squaredNorm();
    }
    template <int Dim>
    Tensor<Dim> first_piola_stress(const Tensor<Dim>& f) const {
        const Tensor<Dim> e = green_strain<Dim>(f - Tensor<Dim>::Identity());
        return f * (lambda * e.trace() * Tensor<Dim>::Identity() + 2 * mu * e);
    }
};

}  // namespace sluice
