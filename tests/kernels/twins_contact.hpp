// Plain scalar twins of the passes of contact, and the energy of contact from nothing but positions.
#pragma once

#include "tests/kernels/twins.hpp"

namespace sluice::twin {

/// Σ V_j W, then Σ V_j ∇W
template <int Dim>
Sums<1 + Dim> contact_sums(const Particles<Dim>& body, const Particles<Dim>& others) {
    return sum_all<1 + Dim>(body, others, [&](std::size_t, std::size_t j, const PairOf<Dim>& ij) {
        Vec<1 + Dim> t;
        t[0] = others.volume[j] * ij.w;
        for (int k = 0; k < Dim; ++k) t[1 + k] = others.volume[j] * ij.grad[k];
        return t;
    });
}

/// −Σ V_j (p_i + p_j) ∇W
template <int Dim>
Sums<Dim> contact_force(const Particles<Dim>& body, const Particles<Dim>& others) {
    return sum_all<Dim>(body, others, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        return -others.volume[j] * (body.pressure[i] + others.pressure[j]) * ij.grad;
    });
}

/// ½ k Σ V_i (σ_i − σ_0)₊² of one body's particles among the other's.
template <int Dim>
double contact_energy(const Particles<Dim>& body, const Particles<Dim>& others, double k, double threshold) {
    double energy = 0;
    for (std::size_t i = 0; i < body.size(); ++i) {
        double sigma = 0;
        for (std::size_t j = 0; j < others.size(); ++j) {
            const double h = 0.5 * (body.h[i] + others.h[j]);
            sigma += others.volume[j] * PairOf<Dim>(body.position[i], others.position[j], h).w;
        }
        const double excess = sigma > threshold ? sigma - threshold : 0;
        energy += 0.5 * k * body.volume[i] * excess * excess;
    }
    return energy;
}

}  // namespace sluice::twin
