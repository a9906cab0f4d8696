// Plain scalar twins of the fluid's further terms: laminar viscosity, density diffusion, shifting.
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

/// Eq. (8) and δ c0 Σ_j h V_j Ψ_ij·∇W, Ψ_ij = 2 (ρ_j − ρ_i − expected(i, j)) (x_j − x_i)/r²; delta_c = δ c0.
template <int Dim, class Expected>
Sums<1> diffusive_continuity(const Particles<Dim>& p, double delta_c, const Expected& expected) {
    return sum_all<1>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        if (ij.r == 0) return Vec<1>{};
        const double difference = p.density[j] - p.density[i] - expected(i, j);
        double sum = 0;
        for (int k = 0; k < Dim; ++k) {
            const double psi = 2 * difference * (p.position[j][k] - p.position[i][k]) / (ij.r * ij.r);
            sum += p.mass[j] * (p.velocity[i][k] - p.velocity[j][k]) * ij.grad[k];
            sum += delta_c * ij.h * p.mass[j] / p.density[j] * psi * ij.grad[k];
        }
        return Vec<1>{{sum}};
    });
}

/// Σ V (ρ_j − ρ_i) ∇W, then Σ V (x_j − x_i) ⊗ ∇W, row by row.
template <int Dim>
Sums<Dim + Dim * Dim> density_gradient_sums(const Particles<Dim>& p) {
    return sum_all<Dim + Dim * Dim>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        Vec<Dim + Dim * Dim> t;
        for (int c = 0; c < Dim; ++c) {
            const double v_grad = p.mass[j] / p.density[j] * ij.grad[c];
            t[c] = v_grad * (p.density[j] - p.density[i]);
            for (int r = 0; r < Dim; ++r) t[Dim + r * Dim + c] = v_grad * (p.position[j][r] - p.position[i][r]);
        }
        return t;
    });
}

/// Σ V_j (1 + R (W/W(d))^4) ∇W with the volumes of `others`; h_over_d gives d from the pair's h.
template <int Dim>
Sums<Dim> concentration_gradient(const Particles<Dim>& p, const Particles<Dim>& others, double repulsion,
                                 double h_over_d) {
    return sum_all<Dim>(p, others, [&](std::size_t, std::size_t j, const PairOf<Dim>& ij) {
        const double f = ij.w / twin::w(Dim, ij.h / h_over_d, ij.h);
        return others.volume[j] * (1 + repulsion * std::pow(f, 4)) * ij.grad;
    });
}

/// −Σ V_j x_ij·∇W
template <int Dim>
Sums<1> position_divergence(const Particles<Dim>& p, const Particles<Dim>& others) {
    return sum_all<1>(p, others, [&](std::size_t, std::size_t j, const PairOf<Dim>& ij) {
        double x_grad = 0;
        for (int k = 0; k < Dim; ++k) x_grad += ij.x[k] * ij.grad[k];
        return Vec<1>{{-others.volume[j] * x_grad}};
    });
}

/// Σ V_j W
template <int Dim>
Sums<1> concentration(const Particles<Dim>& p, const Particles<Dim>& others) {
    return sum_all<1>(p, others, [&](std::size_t, std::size_t j, const PairOf<Dim>& ij) {
        return Vec<1>{{others.volume[j] * ij.w}};
    });
}

}  // namespace sluice::twin
