#include "kernels/passes/shift_passes.hpp"

#include <algorithm>

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/shift_loops.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

template <class Pass, int Dim>
std::uint64_t add_concentration(const ParticleView<Dim>& fluid, const ParticleView<Dim>& others,
                                const NeighborList& list, const ShiftTerms& terms, const PairMethod<Dim>& method,
                                Columns<Dim>& to) {
    Pass pass;
    pass.repulsion = terms.repulsion;
    pass.inverse_shape_at_spacing = 1 / method.smoothing.shape(1 / terms.h_over_d);
    return sum_pairs(pass, method, fluid, others, list, [&to](Index i, const Vec<Dim + 2>& sum) {
        for (std::size_t k = 0; k < Dim; ++k) to.concentration_gradient.c[k][i] += sum[static_cast<int>(k)];
        to.position_divergence[i] += sum[Dim];
        to.concentration[i] += sum[Dim + 1];
    });
}

}  // namespace

template <int Dim>
void clear_surroundings(Columns<Dim>& fluid, std::size_t owned, std::size_t all) {
    const auto clear = [](ScalarField& column, std::size_t n) {
        resize_tight(column, n);
        std::fill(column.begin(), column.end(), 0.0);
    };
    for (auto* vectors : {&fluid.concentration_gradient, &fluid.surface_normal})
        for (ScalarField& column : vectors->c) clear(column, owned);
    clear(fluid.position_divergence, owned);
    clear(fluid.concentration, owned);
    clear(fluid.surface_volume, all);
}

template <int Dim>
std::uint64_t shift_sums(const ParticleView<Dim>& fluid, const NeighborList& list, const ShiftTerms& terms,
                         const PairMethod<Dim>& method, Columns<Dim>& to) {
    return add_concentration<FluidConcentration<Dim>>(fluid, fluid, list, terms, method, to);
}

template <int Dim>
std::uint64_t boundary_shift_sums(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary,
                                  const NeighborList& list, const ShiftTerms& terms, const PairMethod<Dim>& method,
                                  Columns<Dim>& to) {
    return add_concentration<BoundaryConcentration<Dim>>(fluid, boundary, list, terms, method, to);
}

template <int Dim>
void mark_free_surface(const ParticleView<Dim>& fluid, std::size_t owned, Columns<Dim>& to) {
    parallel_for(owned, [&](std::size_t i) {
        const double volume = fluid.mass[i] / fluid.density[i];
        to.surface_volume[i] = to.position_divergence[i] < surface_divergence<Dim> ? volume : 0.0;
    });
}

template <int Dim>
std::uint64_t surface_normals(const ParticleView<Dim>& fluid, const NeighborList& list, const PairMethod<Dim>& method,
                              Columns<Dim>& to) {
    ParticleView<Dim> surface = fluid;
    surface.volume = to.surface_volume.data();
    return add_vectors(SurfaceNormal<Dim>{}, method, fluid, surface, list, to.surface_normal);
}

#define SLUICE_INSTANTIATE(Dim)                                                                                        \
    template void clear_surroundings<Dim>(Columns<Dim>&, std::size_t, std::size_t); \
    template std::uint64_t shift_sums<Dim>(const ParticleView<Dim>&, const NeighborList&, const ShiftTerms&,           \
                                           const PairMethod<Dim>&, Columns<Dim>&);                                 \
    template std::uint64_t boundary_shift_sums<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,                \
                                                    const NeighborList&, const ShiftTerms&, const PairMethod<Dim>&,    \
                                                    Columns<Dim>&);                                                \
    template void mark_free_surface<Dim>(const ParticleView<Dim>&, std::size_t, Columns<Dim>&);                    \
    template std::uint64_t surface_normals<Dim>(const ParticleView<Dim>&, const NeighborList&, const PairMethod<Dim>&, \
                                                Columns<Dim>&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
