#include "kernels/wall_passes.hpp"

#include <algorithm>

#include "kernels/pair_loop.hpp"
#include "kernels/terms/fixed_ghost.hpp"

namespace sluice {

template <int Dim, class Real>
std::uint64_t fixed_ghost_pressure(const ParticleView<Dim>& wall, const ParticleView<Dim>& fluid,
                                   const NeighborList& list, const Vec<Dim>& gravity, ScalarField& pressure) {
    const auto g = vec_cast<Real>(gravity);
    std::fill(pressure.begin(), pressure.end(), 0.0);
    constexpr unsigned reads = column::mass | column::density | column::pressure;
    return sum_pairs<DefaultSmoothing<Dim>, 0u, reads, 2, Real>(
        wall, fluid, list,
        [g](const auto& ij) {
            const Real v_w = ij.m_j() / ij.rho_j() * ij.w();
            return Vec<2, Real>{{v_w, v_w * (ij.p_j() + ij.rho_j() * dot(g, ij.x_ij))}};
        },
        [&](Index i, const Vec<2>& sum) { pressure[i] = sum[0] > 0 ? std::max(sum[1] / sum[0], 0.0) : 0.0; });
}

template <int Dim, class Real>
std::uint64_t fixed_ghost_force(const ParticleView<Dim>& fluid, const ParticleView<Dim>& wall, const NeighborList& list,
                                VectorField<Dim>& acceleration) {
    return gather_vectors<Real, DefaultSmoothing<Dim>>(fluid, wall, list, acceleration, FixedGhostPressure{});
}

template <int Dim, class Real>
std::uint64_t fixed_ghost_continuity(const ParticleView<Dim>& fluid, const ParticleView<Dim>& wall,
                                     const NeighborList& list, ScalarField& density_rate) {
    return gather_scalars<Real, DefaultSmoothing<Dim>>(fluid, wall, list, density_rate, FixedGhostContinuity{});
}

#define SLUICE_INSTANTIATE(Dim, Real)                                                                            \
    template std::uint64_t fixed_ghost_pressure<Dim, Real>(const ParticleView<Dim>&, const ParticleView<Dim>&,   \
                                                           const NeighborList&, const Vec<Dim>&, ScalarField&);  \
    template std::uint64_t fixed_ghost_force<Dim, Real>(const ParticleView<Dim>&, const ParticleView<Dim>&,      \
                                                        const NeighborList&, VectorField<Dim>&);                 \
    template std::uint64_t fixed_ghost_continuity<Dim, Real>(const ParticleView<Dim>&, const ParticleView<Dim>&, \
                                                             const NeighborList&, ScalarField&);
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
