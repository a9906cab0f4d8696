// Plain scalar twins of the passes between the fluid and a moving boundary, and of the pressure of moving ghosts.
#pragma once

#include "tests/kernels/twins.hpp"

namespace sluice::twin {

/// p_f + p_s with p_s = p_f + ρ_f (g − a_s)·(x_s − x_f), or 0 where that is negative.
template <int Dim>
double pair_pressure(const Particles<Dim>& fluid, std::size_t f, const Vec<Dim>& x_sf, const Vec<Dim>& a_s,
                     const Vec<Dim>& g) {
    double p_s = fluid.pressure[f];
    for (int k = 0; k < Dim; ++k) p_s += fluid.density[f] * (g[k] - a_s[k]) * x_sf[k];
    return std::max(fluid.pressure[f] + p_s, 0.0);
}

/// −1/ρ_f Σ V_s P_fs ∇_f W
template <int Dim>
Sums<Dim> boundary_pressure(const Particles<Dim>& fluid, const Particles<Dim>& solid,
                            const VectorField<Dim>& acceleration, const Vec<Dim>& g) {
    return sum_all<Dim>(fluid, solid, [&](std::size_t f, std::size_t s, const PairOf<Dim>& fs) {
        const double p = pair_pressure<Dim>(fluid, f, -1.0 * fs.x, acceleration[s], g);
        return -solid.volume[s] * p / fluid.density[f] * fs.grad;
    });
}

/// −V_s Σ V_f P_fs ∇_s W
template <int Dim>
Sums<Dim> boundary_reaction(const Particles<Dim>& solid, const Particles<Dim>& fluid,
                            const VectorField<Dim>& acceleration, const Vec<Dim>& g) {
    return sum_all<Dim>(solid, fluid, [&](std::size_t s, std::size_t f, const PairOf<Dim>& sf) {
        const double p = pair_pressure<Dim>(fluid, f, sf.x, acceleration[s], g);
        return -solid.volume[s] * fluid.mass[f] / fluid.density[f] * p * sf.grad;
    });
}

/// ρ_f Σ V_s (v_f − v_s)·∇_f W
template <int Dim>
Sums<1> boundary_continuity(const Particles<Dim>& fluid, const Particles<Dim>& solid) {
    return sum_all<1>(fluid, solid, [&](std::size_t f, std::size_t s, const PairOf<Dim>& fs) {
        double sum = 0;
        for (int k = 0; k < Dim; ++k)
            sum += fluid.density[f] * solid.volume[s] * (fluid.velocity[f][k] - solid.velocity[s][k]) * fs.grad[k];
        return Vec<1>{{sum}};
    });
}

/// Σ V W and Σ V (p_f + ρ_f g_w·(x_w − x_f)) W, each ghost with the gravity g_w of its own wall.
template <int Dim>
Sums<2> moving_ghost_pressure_sums(const Particles<Dim>& wall, const Particles<Dim>& fluid,
                                   const std::vector<Vec<Dim>>& gravity, const Array<std::uint16_t>& wall_of) {
    return sum_all<2>(wall, fluid, [&](std::size_t w, std::size_t f, const PairOf<Dim>& wf) {
        const double v_w = fluid.mass[f] / fluid.density[f] * wf.w;
        double head = 0;
        for (int k = 0; k < Dim; ++k) head += fluid.density[f] * gravity[wall_of[w]][k] * wf.x[k];
        return Vec<2>{{v_w, v_w * (fluid.pressure[f] + head)}};
    });
}

}  // namespace sluice::twin
