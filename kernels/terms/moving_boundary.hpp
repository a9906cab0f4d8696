// A solid's particles as the fluid's moving boundary: pressure, reaction and approach.
//
// The pressure at a boundary particle is extrapolated from the fluid particle that feels it, pair by pair, by the
// gradient that an accelerated wall exerts [Adami, Hu & Adams 2012, eq. 25; one-sided: Zhang, Rezavand & Hu 2021]: with
// f the fluid's particle and s the solid's,
//   p_s = p_f + ρ_f (g − a_s)·(x_s − x_f)
// A thin structure may so have a different pressure on either face, no pass is needed to extrapolate, and the fluid's
// own pressure drives it away from the wall, which keeps the layer there stable (kernels/passes/interface_passes.hpp). The
// pair exchanges, in both passes,
//   F_fs = −V_f V_s P_fs ∇_f W_fs = −F_sf,   P_fs = max(p_f + p_s, 0)          [N; N/m in 2D]
// A solid pushes water but does not hold it.
#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// The fluid's side: a_f = F_f/m_f = −1/ρ_f Σ_s V_s P_fs ∇_f W_fs          [m/s²]
template <int Dim>
struct MovingBoundaryPressure {
    static constexpr ColumnSet reads_i = column::pressure | column::density,
                              reads_j = column::volume | column::mean_acceleration;

    Vec<Dim> gravity;  ///< g [m/s²]

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& fs) const {
        using Real = typename Pair::Real;
        const auto a_s = fs.j(column::mean_acceleration);
        Real rise(0);  // (g − a_s)·(x_s − x_f)
        unroll<Dim>([&](int k) __attribute__((always_inline)) { rise += (a_s[k] - Real(gravity[k])) * fs.x_ij[k]; });
        const Real pressure = larger(Real(2) * fs.p_i() + fs.rho_i() * rise, Real(0));
        return (-(fs.volume_j() * pressure * reciprocal(fs.rho_i()) * fs.grad_w_over_x())) * fs.x_ij;
    }
};

/// The solid's side, per its volume: F_s/V_s = −Σ_f V_f P_fs ∇_s W_sf          [N/m³]
template <int Dim>
struct MovingBoundaryReaction {
    static constexpr ColumnSet reads_i = column::mean_acceleration,
                              reads_j = column::mass | column::density | column::pressure;

    Vec<Dim> gravity;  ///< g [m/s²]

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& sf) const {
        using Real = typename Pair::Real;
        const auto a_s = sf.i(column::mean_acceleration);
        Real rise(0);  // x_s − x_f is the pair's own x_ij here
        unroll<Dim>([&](int k) __attribute__((always_inline)) { rise += (Real(gravity[k]) - a_s[k]) * sf.x_ij[k]; });
        const Real pressure = larger(Real(2) * sf.p_j() + sf.rho_j() * rise, Real(0));
        return (-(pressure * reciprocal(sf.rho_j()) * sf.m_grad_w_over_x())) * sf.x_ij;
    }
};

/// Continuity across a moving boundary: eq. (8) of Antoci2007 with a neighbour of the fluid's own density.
///   dρ_f/dt = ρ_f Σ_s V_s (v_f − v_s)·∇_f W_fs          [kg/m³/s]
struct MovingBoundaryContinuity {
    static constexpr ColumnSet reads_i = column::velocity | column::density, reads_j = column::velocity | column::volume;

    template <class Pair>
    [[gnu::always_inline]] auto operator()(const Pair& fs) const {
        return fs.rho_i() * fs.volume_j() * fs.grad_w_over_x() * dot(fs.v_ij(), fs.x_ij);
    }
};

}  // namespace sluice
