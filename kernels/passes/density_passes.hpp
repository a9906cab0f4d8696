// Pair passes of the fluid's density diffusion. Each returns the directed pairs inside the support.
#pragma once

#include <cstdint>

#include "kernels/choices.hpp"
#include "kernels/pairs/block_loop.hpp"

namespace sluice {

template <int Dim>
struct DiffusionTerms {
    DensityDiffusion kind = DensityDiffusion::none;
    double sound_speed = 0;    ///< c0 [m/s]
    double coefficient = 0.1;  ///< δ [Antuono et al. 2010]
    double density = 0;        ///< ρ0 [kg/m³], for Fourtakas et al.
    Vec<Dim> gravity;          ///< g [m/s²], for Fourtakas et al.
};

/// density_rate += eq. (8), as `continuity`, and diffusion, in one loop. Antuono's reads the column density_gradient.
template <int Dim>
std::uint64_t diffusive_continuity(const ParticleView<Dim>& fluid, const NeighborList& list,
                                   const DiffusionTerms<Dim>& terms, const PairMethod<Dim>& method,
                                   ScalarField& density_rate);

/// density_rate += continuity by volumes, and diffusion within each fluid of its column excess_density, in one loop
/// (kernels/terms/multiphase.hpp). coefficient: δ
template <int Dim>
std::uint64_t multiphase_continuity(const ParticleView<Dim>& fluid, const NeighborList& list, double coefficient,
                                    const PairMethod<Dim>& method, ScalarField& density_rate);

/// gradient = ⟨∇ρ⟩_i = M_i⁻¹ Σ_j V_j (ρ_j − ρ_i) ∇_i W_ij, M_i = Σ_j V_j (x_j − x_i) ⊗ ∇_i W_ij, for listed particles
/// [Antuono et al. 2010; Randles & Libersky 1996]. Exact for every linear density field, at a free surface too. A
/// particle with too few neighbours to define M gets 0, as in solid_rates: it is diffused as by Molteni & Colagrossi.
template <int Dim>
std::uint64_t density_gradient(const ParticleView<Dim>& fluid, const NeighborList& list, const PairMethod<Dim>& method,
                               VectorField<Dim>& gradient);

}  // namespace sluice
