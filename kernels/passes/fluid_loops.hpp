// The fluid's passes over pairs, as sets of terms.
#pragma once

#include "kernels/pairs/momentum_terms.hpp"
#include "kernels/terms/central_viscosity.hpp"
#include "kernels/terms/continuity.hpp"
#include "kernels/terms/laminar_viscosity.hpp"
#include "kernels/terms/symmetric_pressure.hpp"

namespace sluice {

template <int Dim>
using InviscidMomentum = MomentumTerms<Dim, SymmetricPressure>;
template <int Dim>
using ViscousMomentum = MomentumTerms<Dim, SymmetricPressure, CentralViscosity>;
template <int Dim, class... More>
inline constexpr std::string_view pass_name<MomentumTerms<Dim, SymmetricPressure, More...>> = "fluid momentum";

/// A pass of its own: as a branch in the loop of ViscousMomentum it cost that one 5 to 15 % (bench: fluid_momentum).
template <int Dim>
struct MorrisMomentum {
    static constexpr std::string_view name = "fluid momentum";
    static constexpr int dim = Dim, outputs = Dim;
    static constexpr ColumnSet reads_i = InviscidMomentum<Dim>::reads_i | MorrisViscosity::reads_i;
    static constexpr ColumnSet reads_j = InviscidMomentum<Dim>::reads_j | MorrisViscosity::reads_j;

    MorrisViscosity viscosity;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ij) const {
        return InviscidMomentum<Dim>{}(ij) + viscosity(ij);
    }
};

template <int Dim>
struct DensityRate : Continuity {
    static constexpr std::string_view name = "fluid continuity";
    static constexpr int dim = Dim, outputs = 1;

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& ij) const {
        return {{Continuity::operator()(ij)}};
    }
};

/// Numerator and denominator of eq. (16), both halved: Σ_j V_j (v_j − v_i) W_ij and Σ_j V_j W_ij with V_j = m_j/ρ̄_ij.
template <int Dim>
struct FilterSums {
    static constexpr std::string_view name = "velocity filter";
    static constexpr int dim = Dim, outputs = Dim + 1;
    static constexpr ColumnSet reads_i = column::velocity | column::density, reads_j = reads_i | column::mass;

    template <class Pair>
    [[gnu::always_inline]] Vec<outputs, typename Pair::Real> operator()(const Pair& ij) const {
        using Real = typename Pair::Real;
        const Real v_w = ij.m_w() * reciprocal(ij.rho_i() + ij.rho_j());
        const auto v_ij = ij.v_ij();
        Vec<outputs, Real> out;
        unroll<Dim>([&](int k) __attribute__((always_inline)) { out[k] = -(v_w * v_ij[k]); });
        out[Dim] = v_w;
        return out;
    }
};

}  // namespace sluice
