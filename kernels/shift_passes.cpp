#include "kernels/shift_passes.hpp"

#include <algorithm>

#include "kernels/pair_sum.hpp"
#include "kernels/shift_loops.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

template <class Pass, int Dim>
std::uint64_t add_concentration(const ParticleView<Dim>& fluid, const ParticleView<Dim>& others,
                                const NeighborList& list, const ShiftTerms& terms, const PairMethod<Dim>& method,
                                ShiftFields<Dim>& fields) {
    Pass pass;
    pass.repulsion = terms.repulsion;
    pass.inverse_shape_at_spacing = 1 / method.smoothing.shape(1 / terms.h_over_d);
    return sum_pairs(pass, method, fluid, others, list, [&fields](Index i, const Vec<Dim + 2>& sum) {
        for (std::size_t k = 0; k < Dim; ++k) fields.concentration_gradient.c[k][i] += sum[static_cast<int>(k)];
        fields.position_divergence[i] += sum[Dim];
        fields.concentration[i] += sum[Dim + 1];
    });
}

}  // namespace

template <int Dim>
void ShiftFields<Dim>::reset(std::size_t n) {
    const auto clear = [n](ScalarField& column) {
        resize_tight(column, n);
        std::fill(column.begin(), column.end(), 0.0);
    };
    for (auto* vectors : {&concentration_gradient, &surface_normal})
        for (ScalarField& column : vectors->c) clear(column);
    for (ScalarField* column : {&position_divergence, &concentration, &surface_volume}) clear(*column);
}

template <int Dim>
std::uint64_t shift_sums(const ParticleView<Dim>& fluid, const NeighborList& list, const ShiftTerms& terms,
                         const PairMethod<Dim>& method, ShiftFields<Dim>& fields) {
    return add_concentration<FluidConcentration<Dim>>(fluid, fluid, list, terms, method, fields);
}

template <int Dim>
std::uint64_t boundary_shift_sums(const ParticleView<Dim>& fluid, const ParticleView<Dim>& boundary,
                                  const NeighborList& list, const ShiftTerms& terms, const PairMethod<Dim>& method,
                                  ShiftFields<Dim>& fields) {
    return add_concentration<BoundaryConcentration<Dim>>(fluid, boundary, list, terms, method, fields);
}

template <int Dim>
void mark_free_surface(const ParticleView<Dim>& fluid, std::size_t owned, ShiftFields<Dim>& fields) {
    parallel_for(owned, [&](std::size_t i) {
        const double volume = fluid.mass[i] / fluid.density[i];
        fields.surface_volume[i] = fields.position_divergence[i] < surface_divergence<Dim> ? volume : 0.0;
    });
}

template <int Dim>
std::uint64_t surface_normals(const ParticleView<Dim>& fluid, const NeighborList& list, const PairMethod<Dim>& method,
                              ShiftFields<Dim>& fields) {
    ParticleView<Dim> surface = fluid;
    surface.volume = fields.surface_volume.data();
    return add_vectors(SurfaceNormal<Dim>{}, method, fluid, surface, list, fields.surface_normal);
}

#define SLUICE_INSTANTIATE(Dim)                                                                                        \
    template struct ShiftFields<Dim>;                                                                                  \
    template std::uint64_t shift_sums<Dim>(const ParticleView<Dim>&, const NeighborList&, const ShiftTerms&,           \
                                           const PairMethod<Dim>&, ShiftFields<Dim>&);                                 \
    template std::uint64_t boundary_shift_sums<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&,                \
                                                    const NeighborList&, const ShiftTerms&, const PairMethod<Dim>&,    \
                                                    ShiftFields<Dim>&);                                                \
    template void mark_free_surface<Dim>(const ParticleView<Dim>&, std::size_t, ShiftFields<Dim>&);                    \
    template std::uint64_t surface_normals<Dim>(const ParticleView<Dim>&, const NeighborList&, const PairMethod<Dim>&, \
                                                ShiftFields<Dim>&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
