#include "kernels/fluid_passes.hpp"

#include <algorithm>

#include "kernels/fluid_loops.hpp"

namespace sluice {

template <int Dim>
std::uint64_t fluid_momentum(const ParticleView<Dim>& fluid, const NeighborList& list, const FluidTerms& terms,
                             const PairMethod<Dim>& method, VectorField<Dim>& acceleration) {
    if (terms.artificial_viscosity == 0)
        return add_vectors(InviscidMomentum<Dim>{}, method, fluid, fluid, list, acceleration);
    const ViscousMomentum<Dim> viscous{{}, {terms.artificial_viscosity, terms.sound_speed}};
    return add_vectors(viscous, method, fluid, fluid, list, acceleration);
}

template <int Dim>
std::uint64_t continuity(const ParticleView<Dim>& particles, const NeighborList& list, const PairMethod<Dim>& method,
                         ScalarField& density_rate) {
    return add_scalars(DensityRate<Dim>{}, method, particles, particles, list, density_rate);
}

template <int Dim>
std::uint64_t fluid_rates(const ParticleView<Dim>& fluid, const NeighborList& list, const FluidTerms& terms,
                          const PairMethod<Dim>& method, VectorField<Dim>& acceleration, ScalarField& density_rate) {
    const FluidRates<Dim> rates{{{}, {terms.artificial_viscosity, terms.sound_speed}}};
    return sum_pairs(rates, method, fluid, fluid, list, [&](Index i, const Vec<Dim + 1>& sum) {
        Vec<Dim> a;
        for (int k = 0; k < Dim; ++k) a[k] = sum[k];
        acceleration.set(i, acceleration[i] + a);
        density_rate[i] += sum[Dim];
    });
}

template <int Dim>
std::uint64_t velocity_filter(const ParticleView<Dim>& particles, const NeighborList& list, double theta,
                              const PairMethod<Dim>& method, VectorField<Dim>& correction) {
    for (ScalarField& column : correction.c) std::fill(column.begin(), column.end(), 0.0);
    return sum_pairs(FilterSums<Dim>{}, method, particles, particles, list, [&](Index i, const Vec<Dim + 1>& sum) {
        Vec<Dim> v;
        for (int k = 0; k < Dim; ++k) v[k] = (1 - theta) * sum[k] / sum[Dim];
        correction.set(i, v);
    });
}

#define SLUICE_INSTANTIATE(Dim)                                                                                   \
    template std::uint64_t fluid_momentum<Dim>(const ParticleView<Dim>&, const NeighborList&, const FluidTerms&,  \
                                               const PairMethod<Dim>&, VectorField<Dim>&);                        \
    template std::uint64_t continuity<Dim>(const ParticleView<Dim>&, const NeighborList&, const PairMethod<Dim>&, \
                                           ScalarField&);                                                         \
    template std::uint64_t fluid_rates<Dim>(const ParticleView<Dim>&, const NeighborList&, const FluidTerms&,     \
                                            const PairMethod<Dim>&, VectorField<Dim>&, ScalarField&);             \
    template std::uint64_t velocity_filter<Dim>(const ParticleView<Dim>&, const NeighborList&, double,            \
                                                const PairMethod<Dim>&, VectorField<Dim>&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
