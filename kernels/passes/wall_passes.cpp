#include "kernels/passes/wall_passes.hpp"

#include <algorithm>

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/wall_loops.hpp"

namespace sluice {

template <int Dim>
std::uint64_t fixed_ghost_pressure(const ParticleView<Dim>& wall, const ParticleView<Dim>& fluid,
                                   const NeighborList& list, const Vec<Dim>& gravity, const PairMethod<Dim>& method,
                                   ScalarField& pressure) {
    std::fill(pressure.begin(), pressure.end(), 0.0);
    return sum_pairs(GhostPressureSums<Dim>{gravity}, method, wall, fluid, list, [&](Index i, const Vec<2>& sum) {
        pressure[i] = sum[0] > 0 ? std::max(sum[1] / sum[0], 0.0) : 0.0;
    });
}

template <int Dim>
std::uint64_t moving_ghost_pressure(const ParticleView<Dim>& wall, const ParticleView<Dim>& fluid,
                                    const NeighborList& list, const std::vector<Vec<Dim>>& effective_gravity,
                                    const Array<std::uint16_t>& body, const PairMethod<Dim>& method,
                                    ScalarField& pressure) {
    std::fill(pressure.begin(), pressure.end(), 0.0);
    using Sums = MovingGhostPressureSums<Dim>;
    return sum_pairs(Sums{}, method, wall, fluid, list, [&](Index i, const Vec<Sums::outputs>& sum) {
        if (!(sum[0] > 0)) return;
        double weighted = sum[1];
        for (int k = 0; k < Dim; ++k) weighted += effective_gravity[body[i]][k] * sum[2 + k];
        pressure[i] = std::max(weighted / sum[0], 0.0);
    });
}

template <int Dim>
std::uint64_t fixed_ghost_force(const ParticleView<Dim>& fluid, const ParticleView<Dim>& wall, const NeighborList& list,
                                const PairMethod<Dim>& method, VectorField<Dim>& acceleration) {
    return add_vectors(GhostPressure<Dim>{}, method, fluid, wall, list, acceleration);
}

template <int Dim>
std::uint64_t fixed_ghost_continuity(const ParticleView<Dim>& fluid, const ParticleView<Dim>& wall,
                                     const NeighborList& list, const PairMethod<Dim>& method,
                                     ScalarField& density_rate) {
    return add_scalars(GhostContinuity<Dim>{}, method, fluid, wall, list, density_rate);
}

#define SLUICE_INSTANTIATE(Dim)                                                                                    \
    template std::uint64_t fixed_ghost_pressure<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,           \
                                                     const NeighborList&, const Vec<Dim>&, const PairMethod<Dim>&, \
                                                     ScalarField&);                                                \
    template std::uint64_t moving_ghost_pressure<Dim>(                                                             \
        const ParticleView<Dim>&, const ParticleView<Dim>&, const NeighborList&, const std::vector<Vec<Dim>>&,     \
        const Array<std::uint16_t>&, const PairMethod<Dim>&, ScalarField&);                                        \
    template std::uint64_t fixed_ghost_force<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,              \
                                                  const NeighborList&, const PairMethod<Dim>&, VectorField<Dim>&); \
    template std::uint64_t fixed_ghost_continuity<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,         \
                                                       const NeighborList&, const PairMethod<Dim>&, ScalarField&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
