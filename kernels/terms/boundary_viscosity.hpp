// Friction of a viscous fluid at a boundary where it does not slip.
//
// A boundary particle stands for fluid that moves with v_g = 2 v_w − ṽ, where v_w is the boundary's velocity and ṽ the
// mean of the fluid's around it [Adami, Hu & Adams 2012, eqs. 22, 23]: half-way between, at the boundary, the fluid
// moves with v_w. Its viscosity is that of the fluid, in the form of Morris et al.
// (kernels/terms/laminar_viscosity.hpp); the pair of a fluid particle f and a boundary particle w exchanges
//   F_fw = 2 ν m_f V_w (∂W/∂r / r) (v_f − v_g) = −F_wf          [N; N/m in 2D]
#pragma once

#include "kernels/pairs/pair.hpp"

namespace sluice {

/// The fluid's side: a_f = 2 ν Σ_w V_w (∂W/∂r / r) (v_f − v_g)          [m/s²]
/// The boundary's velocity column holds v_g, its volume column 0 where the fluid slips.
struct BoundaryFriction {
    static constexpr ColumnSet reads_i = column::velocity, reads_j = column::velocity | column::volume;

    double viscosity = 0;  ///< ν [m²/s]

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& fw) const {
        using Real = typename Pair::Real;
        return (Real(2 * viscosity) * fw.volume_j() * fw.grad_w_over_x()) * fw.v_ij();
    }
};

/// The boundary's side, per its volume: 2 ν Σ_f m_f (∂W/∂r / r) (v_g − v_f)          [N/m³]
struct BoundaryFrictionReaction {
    static constexpr ColumnSet reads_i = column::velocity, reads_j = column::velocity | column::mass;

    double viscosity = 0;  ///< ν [m²/s]

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& wf) const {
        using Real = typename Pair::Real;
        return (Real(2 * viscosity) * wf.m_grad_w_over_x()) * wf.v_ij();
    }
};

}  // namespace sluice
