#include "kernels/passes/fluid_passes.hpp"

#include <algorithm>

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/fluid_loops.hpp"
#include "kernels/passes/multiphase_loops.hpp"
#include "kernels/terms/artificial_viscosity.hpp"

namespace sluice {
namespace {

/// Of the two kinds that act along the line between particles; zero for the others.
template <int Dim>
CentralViscosity central_viscosity(const FluidTerms& terms) {
    if (terms.viscosity == Viscosity::artificial)
        return ArtificialViscosity{terms.artificial_viscosity, terms.sound_speed}.central();
    if (terms.viscosity == Viscosity::monaghan_gingold)
        return monaghan_gingold_viscosity<Dim>(terms.kinematic_viscosity);
    return {};
}

}  // namespace

template <int Dim>
std::uint64_t fluid_momentum(const ParticleView<Dim>& fluid, const NeighborList& list, const FluidTerms& terms,
                             const PairMethod<Dim>& method, VectorField<Dim>& acceleration) {
    const auto add = [&](const auto& momentum) {
        return add_vectors(momentum, method, fluid, fluid, list, acceleration);
    };
    const CentralViscosity central = central_viscosity<Dim>(terms);
    if (terms.multiphase) {
        if (terms.viscosity == Viscosity::morris) return add(MultiphaseMorrisMomentum<Dim>{{terms.kinematic_viscosity}});
        const double alpha = terms.viscosity == Viscosity::artificial ? terms.artificial_viscosity : 0;
        return add(MultiphaseMomentum<Dim>{{}, {alpha, central.constant, central.limit, central.softening}});
    }
    if (central.per_length != 0 || central.constant != 0) return add(ViscousMomentum<Dim>{{}, central});
    if (terms.viscosity == Viscosity::morris && terms.kinematic_viscosity != 0)
        return add(MorrisMomentum<Dim>{{terms.kinematic_viscosity}});
    return add(InviscidMomentum<Dim>{});
}

template <int Dim>
std::uint64_t continuity(const ParticleView<Dim>& particles, const NeighborList& list, const PairMethod<Dim>& method,
                         ScalarField& density_rate) {
    return add_scalars(DensityRate<Dim>{}, method, particles, particles, list, density_rate);
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
    template std::uint64_t velocity_filter<Dim>(const ParticleView<Dim>&, const NeighborList&, double,            \
                                                const PairMethod<Dim>&, VectorField<Dim>&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
