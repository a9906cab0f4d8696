// Plain scalar twins: for every i, for every j, in long-hand double arithmetic, written from the paper's equations and
// not from the terms. Nothing of kernels/ is called here.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/kernels/particles.hpp"

namespace sluice::twin {

/// W(r, h), piecewise as eq. (9) prints it.
inline double w(int dim, double r, double h) {
    const double s = (dim == 2 ? 10 / (7 * std::numbers::pi) : 1 / std::numbers::pi) / std::pow(h, dim);
    const double q = r / h;
    if (q <= 1) return s * (1 - 3.0 / 2 * q * q + 3.0 / 4 * q * q * q);
    if (q <= 2) return s * (1.0 / 4 * std::pow(2 - q, 3));
    return 0;
}

/// dW/dr
inline double dw_dr(int dim, double r, double h) {
    const double s = (dim == 2 ? 10 / (7 * std::numbers::pi) : 1 / std::numbers::pi) / std::pow(h, dim + 1);
    const double q = r / h;
    if (q <= 1) return s * (-3 * q + 9.0 / 4 * q * q);
    if (q <= 2) return s * (-3.0 / 4 * (2 - q) * (2 - q));
    return 0;
}

/// A directed pair's geometry: x = x_i − x_j, the mean h, W and its gradient with respect to x_i.
template <int Dim>
struct PairOf {
    Vec<Dim> x;
    double r, h, w;
    Vec<Dim> grad;

    PairOf(const Vec<Dim>& x_i, const Vec<Dim>& x_j, double h_ij) : h(h_ij) {
        double r2 = 0;
        for (int k = 0; k < Dim; ++k) {
            x[k] = x_i[k] - x_j[k];
            r2 += x[k] * x[k];
        }
        r = std::sqrt(r2);
        w = twin::w(Dim, r, h);
        for (int k = 0; k < Dim; ++k) grad[k] = r > 0 ? dw_dr(Dim, r, h) * x[k] / r : 0;
    }
};

/// Sums of N numbers per particle, and Σ|term|: what rounding errors are measured against.
template <int N>
struct Sums {
    std::vector<Vec<N>> value, magnitude;
};

/// Σ_j term(i, j, pair), itself included where both sets are one.
template <int N, int Dim, class Term>
Sums<N> sum_all(const Particles<Dim>& a, const Particles<Dim>& b, Term&& term) {
    Sums<N> sums{std::vector<Vec<N>>(a.size()), std::vector<Vec<N>>(a.size())};
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const double h = 0.5 * (a.h[i] + b.h[j]);
            if (norm2(a.position[i] - b.position[j]) > 4.1 * h * h) continue;  // spares W and its powers
            const PairOf<Dim> ij(a.position[i], b.position[j], h);
            if (ij.r > 2 * ij.h) continue;
            const Vec<N> t = term(i, j, ij);
            for (int k = 0; k < N; ++k) {
                sums.value[i][k] += t[k];
                sums.magnitude[i][k] += std::abs(t[k]);
            }
        }
    return sums;
}

/// Dense symmetric tensor times vector; s is ordered xx, yy, xy or xx, yy, zz, xy, xz, yz.
template <int Dim>
Vec<Dim> times(const Vec<sym_components<Dim>>& s, const Vec<Dim>& v) {
    Vec<Dim> r;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j) {
            const int packed = i == j ? i : Dim == 2 ? 2 : i + j + 2;  // xy 3, xz 4, yz 5
            r[i] += s[packed] * v[j];
        }
    return r;
}

/// Π_ij of eq. (12).
template <int Dim>
double viscous_pressure(const Particles<Dim>& p, std::size_t i, std::size_t j, const PairOf<Dim>& ij, double alpha,
                        double c) {
    double vx = 0;
    for (int k = 0; k < Dim; ++k) vx += (p.velocity[i][k] - p.velocity[j][k]) * ij.x[k];
    if (vx >= 0) return 0;
    const double mu = ij.h * vx / (ij.r * ij.r + std::pow(0.1 * ij.h, 2));
    return -alpha * c * mu / ((p.density[i] + p.density[j]) / 2);
}

/// Eq. (10) with Π added.
template <int Dim>
Sums<Dim> fluid_momentum(const Particles<Dim>& p, double alpha, double c) {
    return sum_all<Dim>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        const double pressures =
            p.pressure[i] / (p.density[i] * p.density[i]) + p.pressure[j] / (p.density[j] * p.density[j]);
        return -p.mass[j] * (pressures + viscous_pressure(p, i, j, ij, alpha, c)) * ij.grad;
    });
}

/// Eq. (8).
template <int Dim>
Sums<1> continuity(const Particles<Dim>& p) {
    return sum_all<1>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        double sum = 0;
        for (int k = 0; k < Dim; ++k) sum += p.mass[j] * (p.velocity[i][k] - p.velocity[j][k]) * ij.grad[k];
        return Vec<1>{{sum}};
    });
}

/// The two sums of eq. (16): Σ V (v_j − v_i) W, then Σ V W.
template <int Dim>
Sums<Dim + 1> filter_sums(const Particles<Dim>& p) {
    return sum_all<Dim + 1>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        const double v_w = p.mass[j] / ((p.density[i] + p.density[j]) / 2) * ij.w;
        Vec<Dim + 1> t;
        for (int k = 0; k < Dim; ++k) t[k] = v_w * (p.velocity[j][k] - p.velocity[i][k]);
        t[Dim] = v_w;
        return t;
    });
}

struct SolidConstants {
    double alpha = 0, c = 0;
    bool tension = false;
    int q = 4;
    double h_over_d = 1.5;
};

/// Eq. (11) without gravity.
template <int Dim>
Sums<Dim> solid_momentum(const Particles<Dim>& p, const SolidConstants& s) {
    return sum_all<Dim>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        const double ri2 = p.density[i] * p.density[i], rj2 = p.density[j] * p.density[j];
        const Vec<Dim> from_i = times<Dim>(p.stress[i], ij.grad), from_j = times<Dim>(p.stress[j], ij.grad);
        const Vec<Dim> tension_i = times<Dim>(p.artificial_stress[i], ij.grad),
                       tension_j = times<Dim>(p.artificial_stress[j], ij.grad);
        const double pi = viscous_pressure(p, i, j, ij, s.alpha, s.c);
        const double f = ij.w / twin::w(Dim, ij.h / s.h_over_d, ij.h);
        Vec<Dim> t;
        for (int k = 0; k < Dim; ++k) {
            t[k] = p.mass[j] * (from_i[k] / ri2 + from_j[k] / rj2 - pi * ij.grad[k]);
            if (s.tension) t[k] += p.mass[j] * (tension_i[k] + tension_j[k]) * std::pow(f, s.q);
        }
        return t;
    });
}

/// The two tensors of eq. (15), row by row: Σ V (v_j − v_i) ⊗ ∇W, then Σ V (x_j − x_i) ⊗ ∇W.
template <int Dim>
Sums<2 * Dim * Dim> gradient_sums(const Particles<Dim>& p) {
    return sum_all<2 * Dim * Dim>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        Vec<2 * Dim * Dim> t;
        for (int r = 0; r < Dim; ++r)
            for (int c = 0; c < Dim; ++c) {
                const double v_grad = p.mass[j] / p.density[j] * ij.grad[c];
                t[r * Dim + c] = v_grad * (p.velocity[j][r] - p.velocity[i][r]);
                t[Dim * Dim + r * Dim + c] = v_grad * (p.position[j][r] - p.position[i][r]);
            }
        return t;
    });
}

}  // namespace sluice::twin
