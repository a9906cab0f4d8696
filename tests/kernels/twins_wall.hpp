// Plain scalar twins of the passes at walls of fixed ghosts.
#pragma once

#include "tests/kernels/twins.hpp"

namespace sluice::twin {

/// The two sums of a fixed ghost's pressure: Σ V W and Σ V (p_f + ρ_f g·(x_w − x_f)) W.
template <int Dim>
Sums<2> ghost_pressure_sums(const Particles<Dim>& wall, const Particles<Dim>& fluid, const Vec<Dim>& g) {
    return sum_all<2>(wall, fluid, [&](std::size_t, std::size_t f, const PairOf<Dim>& wf) {
        const double v_w = fluid.mass[f] / fluid.density[f] * wf.w;
        double head = 0;
        for (int k = 0; k < Dim; ++k) head += fluid.density[f] * g[k] * wf.x[k];
        return Vec<2>{{v_w, v_w * (fluid.pressure[f] + head)}};
    });
}

/// −1/ρ_i Σ V_j (p_i + p_j) ∇W
template <int Dim>
Sums<Dim> ghost_force(const Particles<Dim>& fluid, const Particles<Dim>& wall) {
    return sum_all<Dim>(fluid, wall, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        return -wall.volume[j] * (fluid.pressure[i] + wall.pressure[j]) / fluid.density[i] * ij.grad;
    });
}

/// ρ_i Σ V_j v_i · ∇W
template <int Dim>
Sums<1> ghost_continuity(const Particles<Dim>& fluid, const Particles<Dim>& wall) {
    return sum_all<1>(fluid, wall, [&](std::size_t i, std::size_t j, const PairOf<Dim>& ij) {
        double sum = 0;
        for (int k = 0; k < Dim; ++k) sum += fluid.density[i] * wall.volume[j] * fluid.velocity[i][k] * ij.grad[k];
        return Vec<1>{{sum}};
    });
}

}  // namespace sluice::twin
