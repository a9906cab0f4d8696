// Plain twins of the passes in the reference configuration, written from their equations (a)-(c), and the energy (b) of
// a whole body from nothing but its positions.
#pragma once

#include <Eigen/LU>

#include "kernels/principal.hpp"
#include "tests/kernels/twins.hpp"

namespace sluice::twin {

/// The two tensors of (a), row by row: M = Σ V_j (X_j − X_i) ⊗ ∇W, then Σ V_j (x_j − x_i) ⊗ ∇W.
template <int Dim>
Sums<2 * Dim * Dim> deformation_sums(const Particles<Dim>& p, const VectorField<Dim>& x) {
    return sum_all<2 * Dim * Dim>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        Vec<2 * Dim * Dim> t;
        for (int k = 0; k < Dim * Dim; ++k) {
            const double v_grad = p.volume[j] * ij.grad[k % Dim];
            t[k] = -ij.x[k / Dim] * v_grad;
            t[Dim * Dim + k] = (x[j][k / Dim] - x[i][k / Dim]) * v_grad;
        }
        return t;
    });
}

/// Columns of an elastic body, as the momentum pass reads them. T row by row.
template <int Dim>
struct ElasticColumns {
    VectorField<Dim> x;
    TupleField<Dim * Dim> t;
    ScalarField k;
};

/// V_i/m_i Σ V_j {(T_i + T_j) ∇W + (k_i + k_j) x_ij W'/|X|} and viscosity with η = α ρ0 c0. At X_ij = 0 there is no
/// force.
template <int Dim>
Sums<Dim> elastic_momentum(const Particles<Dim>& p, const ElasticColumns<Dim>& c, double eta) {
    return sum_all<Dim>(p, p, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        Vec<Dim> f;
        if (ij.r == 0) return f;
        const double w1 = dw_dr(Dim, ij.r, ij.h) / ij.r;
        const Vec<Dim> x = c.x[i] - c.x[j], v = p.velocity[i] - p.velocity[j];
        double approach = 0, distance2 = std::pow(0.1 * ij.h, 2);
        for (int k = 0; k < Dim; ++k) {
            approach += v[k] * x[k];
            distance2 += x[k] * x[k];
        }
        const double viscous = approach < 0 ? eta * ij.h * approach / distance2 : 0;
        for (int r = 0; r < Dim; ++r) {
            f[r] = (c.k[i] + c.k[j] + viscous) * x[r] * w1;
            for (int s = 0; s < Dim; ++s) f[r] += (c.t[i][r * Dim + s] + c.t[j][r * Dim + s]) * ij.grad[s];
        }
        return (p.volume[i] * p.volume[j] / p.mass[i]) * f;
    });
}

/// The energy (b) of a body: material and hourglass control. A particle whose M has an eigenvalue under 0.01 has none.
template <int Dim>
class ElasticEnergy {
  public:
    using Matrix = Eigen::Matrix<double, Dim, Dim>;
    using Vector = Eigen::Matrix<double, Dim, 1>;

    bool neo_hookean = false;
    double lambda = 0, mu = 0, k = 0;  ///< Lamé's constants, ζ E

    explicit ElasticEnergy(const Particles<Dim>& p) : volume_(p.volume), near_(p.size()) {
        for (std::size_t a = 0; a < p.size(); ++a) {
            Matrix m = Matrix::Zero();
            for (std::size_t b = 0; b < p.size(); ++b) {
                const PairOf<Dim> ab(p.position[a], p.position[b], 0.5 * (p.h[a] + p.h[b]));
                if (ab.r == 0 || ab.r >= 2 * ab.h) continue;
                const Near near{b, -p.volume[b] * dw_dr(Dim, ab.r, ab.h) / ab.r, vector(ab.x)};
                m += near.weight * near.x * near.x.transpose();
                near_[a].push_back(near);
            }
            const bool defined = principal_values<Dim>(m).minCoeff() >= 0.01;
            inverse_.push_back(defined ? Matrix(m.inverse()) : Matrix(Matrix::Zero()));
        }
    }

    /// Of all particles at x.
    double operator()(const VectorField<Dim>& x) const {
        double energy = 0;
        for (std::size_t a = 0; a < near_.size(); ++a) {
            if (inverse_[a].isZero(0)) continue;
            Matrix f = Matrix::Zero();
            for (const Near& b : near_[a]) f += b.weight * vector(x[a] - x[b.index]) * b.x.transpose();
            f = (f * inverse_[a]).eval();
            double errors = 0;
            for (const Near& b : near_[a]) errors += b.weight * (vector(x[a] - x[b.index]) - f * b.x).squaredNorm();
            energy += volume_[a] * (density(f) + 0.5 * k * errors);
        }
        return energy;
    }

  private:
    struct Near {
        std::size_t index;
        double weight;  ///< −V_b W'/|X|
        Vector x;       ///< X_ab
    };

    static Vector vector(const Vec<Dim>& v) {
        Vector r;
        for (int i = 0; i < Dim; ++i) r[i] = v[i];
        return r;
    }
    double density(const Matrix& f) const {
        if (neo_hookean) {
            const double log_j = std::log(f.determinant());
            return mu / 2 * ((f.transpose() * f).trace() - Dim) - mu * log_j + lambda / 2 * log_j * log_j;
        }
        const Matrix e = (f.transpose() * f - Matrix::Identity()) / 2;
        return lambda / 2 * e.trace() * e.trace() + mu * (e * e).trace();
    }

    ScalarField volume_;
    std::vector<std::vector<Near>> near_;
    std::vector<Matrix> inverse_;
};

}  // namespace sluice::twin
