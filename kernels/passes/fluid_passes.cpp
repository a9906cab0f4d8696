#include "kernels/passes/fluid_passes.hpp"

#include <algorithm>

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/fluid_loops.hpp"
#include "kernels/passes/multiphase_loops.hpp"
#include "kernels/terms/artificial_viscosity.hpp"

namespace sluice {
namespace {

/// add(pass) with the pass of one fluid. A viscosity of zero is left out.
template <int Dim, class Add>
std::uint64_t add_momentum(const FluidTerms& terms, const Add& add) {
    const auto add_central = [&](const CentralViscosity& viscosity) {
        return viscosity.per_length != 0 || viscosity.constant != 0 ? add(ViscousMomentum<Dim>{{}, viscosity})
                                                                    : add(InviscidMomentum<Dim>{});
    };
    switch (terms.viscosity) {
        case Viscosity::none:
            break;
        case Viscosity::artificial:
            return add_central(ArtificialViscosity{terms.artificial_viscosity, terms.sound_speed}.central());
        case Viscosity::monaghan_gingold:
            return add_central(monaghan_gingold_viscosity<Dim>(terms.kinematic_viscosity));
        case Viscosity::morris:
            if (terms.kinematic_viscosity == 0) break;
            return add(MorrisMomentum<Dim>{{terms.kinematic_viscosity}});
    }
    return add(InviscidMomentum<Dim>{});
}

/// The same of several fluids; one without viscosity has it zero.
template <int Dim, class Add>
std::uint64_t add_multiphase_momentum(const FluidTerms& terms, const Add& add) {
    const auto add_central = [&](double alpha, const CentralViscosity& viscosity) {
        return add(MultiphaseMomentum<Dim>{{}, {alpha, viscosity.constant, viscosity.limit, viscosity.softening}});
    };
    switch (terms.viscosity) {
        case Viscosity::none:
            break;
        case Viscosity::artificial:
            return add_central(terms.artificial_viscosity,
                               ArtificialViscosity{terms.artificial_viscosity, terms.sound_speed}.central());
        case Viscosity::monaghan_gingold:
            return add_central(0, monaghan_gingold_viscosity<Dim>(terms.kinematic_viscosity));
        case Viscosity::morris:
            return add(MultiphaseMorrisMomentum<Dim>{{terms.kinematic_viscosity}});
    }
    return add_central(0, {});
}

}  // namespace

template <int Dim>
std::uint64_t fluid_momentum(const ParticleView<Dim>& fluid, const NeighborList& list, const FluidTerms& terms,
                             const PairMethod<Dim>& method, VectorField<Dim>& acceleration) {
    const auto add = [&](const auto& momentum) {
        return add_vectors(momentum, method, fluid, fluid, list, acceleration);
    };
    return terms.multiphase ? add_multiphase_momentum<Dim>(terms, add) : add_momentum<Dim>(terms, add);
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
