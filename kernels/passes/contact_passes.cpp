#include "kernels/passes/contact_passes.hpp"

#include <cmath>

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/contact_loops.hpp"

namespace sluice {

template <int Dim>
FlatContact flat_contact(const Smoothing<Dim>& smoothing, double h_over_d) {
    FlatContact flat;
    const int reach = static_cast<int>(std::ceil(smoothing.support * h_over_d));
    const double scale = smoothing.scale(1 / h_over_d);
    const int across = Dim == 3 ? reach : 0;
    for (int z = 1; z <= reach; ++z)
        for (int y = -across; y <= across; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const double r = std::hypot(x, y, z), q = r / h_over_d;
                flat.density += scale * smoothing.shape(q);
                flat.slope -= scale / h_over_d * smoothing.slope_scale * smoothing.reduced_slope(q) * z / r;
            }
    return flat;
}

template <int Dim>
std::uint64_t contact_sums(const ParticleView<Dim>& body, const ParticleView<Dim>& others, const NeighborList& list,
                           const PairMethod<Dim>& method, ScalarField& density, VectorField<Dim>& gradient) {
    return sum_pairs(ContactSums<Dim>{}, method, body, others, list, [&](Index i, const Vec<1 + Dim>& sum) {
        density[i] = sum[0];
        for (std::size_t k = 0; k < Dim; ++k) gradient.c[k][i] = sum[1 + static_cast<int>(k)];
    });
}

template <int Dim>
std::uint64_t contact_force(const ParticleView<Dim>& body, const ParticleView<Dim>& others, const NeighborList& list,
                            const PairMethod<Dim>& method, VectorField<Dim>& force_density) {
    return sum_pairs(ContactForce<Dim>{}, method, body, others, list,
                     [&](Index i, const Vec<Dim>& sum) { force_density.set(i, sum); });
}

#define SLUICE_INSTANTIATE(Dim)                                                                                        \
    template FlatContact flat_contact<Dim>(const Smoothing<Dim>&, double);                                             \
    template std::uint64_t contact_sums<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&, const NeighborList&,  \
                                             const PairMethod<Dim>&, ScalarField&, VectorField<Dim>&);                 \
    template std::uint64_t contact_force<Dim>(const ParticleView<Dim>&, const ParticleView<Dim>&, const NeighborList&, \
                                              const PairMethod<Dim>&, VectorField<Dim>&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
