// Passes over pairs of particles that may be of different materials, as sets of terms.
#pragma once

#include "kernels/pairs/momentum_terms.hpp"
#include "kernels/passes/total_lagrangian_loops.hpp"
#include "kernels/terms/artificial_stress.hpp"
#include "kernels/terms/laminar_viscosity.hpp"
#include "kernels/terms/multiphase.hpp"

namespace sluice {

template <int Dim>
using MultiphaseMomentum = MomentumTerms<Dim, VolumePressure, MultiphaseViscosity>;
template <int Dim, class... More>
inline constexpr std::string_view pass_name<MomentumTerms<Dim, VolumePressure, More...>> = "fluid momentum";

template <int Dim>
struct MultiphaseMorrisMomentum {
    static constexpr std::string_view name = "fluid momentum";
    static constexpr int dim = Dim, outputs = Dim;
    using Pressure = MomentumTerms<Dim, VolumePressure>;
    static constexpr ColumnSet reads_i = Pressure::reads_i | MorrisViscosity::reads_i;
    static constexpr ColumnSet reads_j = Pressure::reads_j | MorrisViscosity::reads_j;

    MorrisViscosity viscosity;

    template <class Pair>
    [[gnu::always_inline]] typename Pair::Vector operator()(const Pair& ij) const {
        return Pressure{}(ij) + viscosity(ij);
    }
};

/// Continuity with diffusion in one loop.
template <int Dim>
struct MultiphaseDensityRate {
    static constexpr std::string_view name = "fluid continuity";
    static constexpr int dim = Dim, outputs = 1;
    static constexpr ColumnSet reads_i = VolumeContinuity::reads_i | MultiphaseDiffusion::reads_i;
    static constexpr ColumnSet reads_j = VolumeContinuity::reads_j | MultiphaseDiffusion::reads_j;

    MultiphaseDiffusion diffusion;

    template <class Pair>
    [[gnu::always_inline]] Vec<1, typename Pair::Real> operator()(const Pair& ij) const {
        return {{VolumeContinuity{}(ij) + ij.m_grad_w_over_x() * diffusion(ij)}};
    }
};

/// Stress of joined solids, with viscosity and, if a scene has it, artificial stress.
template <int Dim, class... More>
using MultiphaseStressDivergence = MomentumTerms<Dim, VolumeStress, MultiphaseViscosity, More...>;
template <int Dim, class... More>
inline constexpr std::string_view pass_name<MomentumTerms<Dim, VolumeStress, More...>> = "solid momentum";

template <int Dim>
using MultiphaseElasticMomentum = ElasticMomentum<Dim, MultiphaseReferenceViscosity>;

}  // namespace sluice
