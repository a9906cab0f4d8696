// Plain scalar twins of the fluid's further terms: laminar viscosity.
#pragma once

#include "tests/kernels/twins.hpp"

namespace sluice::twin {

/// Eq. (10) without viscosity, over m_j.
template <int Dim>
Vec<Dim> of_pressures(const Particles<Dim>& p, std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
    return -(p.pressure[i] / (p.density[i] * p.density[i]) + p.pressure[j] / (p.density[j] * p.density[j])) * ij.grad;
}

/// Eq. (10) with the viscosity of Morris, Fox & Zhu 1997, eq. 22, without η.
template <int Dim>
Sums<Dim> morris_momentum(const Particles<Dim>& p, double nu) {
    return sum_all<Dim>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        if (ij.r == 0) return Vec<Dim>{};
        const double mu_i = p.density[i] * nu, mu_j = p.density[j] * nu;
        double x_grad = 0;
        for (int k = 0; k < Dim; ++k) x_grad += ij.x[k] * ij.grad[k];
        const double along_v = (mu_i + mu_j) / (p.density[i] * p.density[j]) * x_grad / (ij.r * ij.r);
        return p.mass[j] * (of_pressures(p, i, j, ij) + along_v * (p.velocity[i] - p.velocity[j]));
    });
}

/// Eq. (10) with the viscosity of Monaghan 2005, sec. 8.2, without η.
template <int Dim>
Sums<Dim> monaghan_gingold_momentum(const Particles<Dim>& p, double nu) {
    return sum_all<Dim>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        if (ij.r == 0) return Vec<Dim>{};
        double v_x = 0;
        for (int k = 0; k < Dim; ++k) v_x += (p.velocity[i][k] - p.velocity[j][k]) * ij.x[k];
        const double factor = Dim == 2 ? 8 : 10, mean_density = (p.density[i] + p.density[j]) / 2;
        return p.mass[j] * (of_pressures(p, i, j, ij) + factor * nu * v_x / (mean_density * ij.r * ij.r) * ij.grad);
    });
}

}  // namespace sluice::twin
