#include "kernels/fluid_passes.hpp"

#include <algorithm>

#include "kernels/pair_loop.hpp"
#include "kernels/terms/artificial_viscosity.hpp"
#include "kernels/terms/continuity.hpp"
#include "kernels/terms/symmetric_pressure.hpp"

namespace sluice {

template <int Dim, class Real>
std::uint64_t fluid_momentum(const ParticleView<Dim>& fluid, const NeighborList& list, const FluidTerms& terms,
                             VectorField<Dim>& acceleration) {
    using Smoothing = DefaultSmoothing<Dim>;
    if (terms.artificial_viscosity == 0)
        return gather_vectors<Real, Smoothing>(fluid, fluid, list, acceleration, SymmetricPressure{});
    return gather_vectors<Real, Smoothing>(fluid, fluid, list, acceleration, SymmetricPressure{},
                                           ArtificialViscosity{terms.artificial_viscosity, terms.sound_speed});
}

template <int Dim, class Real>
std::uint64_t continuity(const ParticleView<Dim>& particles, const NeighborList& list, ScalarField& density_rate) {
    return gather_scalars<Real, DefaultSmoothing<Dim>>(particles, particles, list, density_rate, Continuity{});
}

template <int Dim, class Real>
std::uint64_t velocity_filter(const ParticleView<Dim>& particles, const NeighborList& list, double theta,
                              VectorField<Dim>& correction) {
    using Smoothing = DefaultSmoothing<Dim>;
    constexpr unsigned reads_i = column::velocity | column::density, reads_j = reads_i | column::mass;
    for (ScalarField& column : correction.c) std::fill(column.begin(), column.end(), 0.0);
    return sum_pairs<Smoothing, reads_i, reads_j, Dim + 1, Real>(
        particles, particles, list,
        [](const auto& ij) {
            const Real v_w = Real(2) * ij.m_j() / (ij.rho_i() + ij.rho_j()) * ij.w();
            const Vec<Dim, Real> v_ij = ij.v_ij();
            Vec<Dim + 1, Real> out;
            unroll<Dim>([&](int k) { out[k] = -v_w * v_ij[k]; });
            out[Dim] = v_w;
            return out;
        },
        [&](Index i, const Vec<Dim + 1>& sum) {
            Vec<Dim> v;
            for (int k = 0; k < Dim; ++k) v[k] = (1 - theta) * sum[k] / sum[Dim];
            correction.set(i, v);
        });
}

#define SLUICE_INSTANTIATE(Dim, Real)                                                                                  \
    template std::uint64_t fluid_momentum<Dim, Real>(const ParticleView<Dim>&, const NeighborList&, const FluidTerms&, \
                                                     VectorField<Dim>&);                                               \
    template std::uint64_t continuity<Dim, Real>(const ParticleView<Dim>&, const NeighborList&, ScalarField&);         \
    template std::uint64_t velocity_filter<Dim, Real>(const ParticleView<Dim>&, const NeighborList&, double,           \
                                                      VectorField<Dim>&);
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
