#include "kernels/passes/solid_passes.hpp"

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/multiphase_loops.hpp"
#include "kernels/passes/solid_loops.hpp"
#include "kernels/tensor.hpp"

namespace sluice {

template <int Dim>
std::uint64_t solid_momentum(const ParticleView<Dim>& solid, const NeighborList& list, const SolidTerms& terms,
                             const PairMethod<Dim>& method, VectorField<Dim>& acceleration) {
    const SymmetricStress stress;
    const ArtificialViscosity viscosity{terms.artificial_viscosity, terms.sound_speed};
    const auto tensile =
        ArtificialStress::with<Dim>(method.smoothing, terms.h_over_d, terms.artificial_stress_exponent);
    const auto add = [&](const auto&... pack) {
        const MomentumTerms<Dim, std::decay_t<decltype(pack)>...> sum{pack...};
        return add_vectors(sum, method, solid, solid, list, acceleration);
    };
    if (terms.multiphase) {
        const MultiphaseViscosity mean{terms.artificial_viscosity, 0, 0, 0.01};
        return terms.artificial_stress != 0 ? add(VolumeStress{}, mean, tensile) : add(VolumeStress{}, mean);
    }
    const bool viscous = terms.artificial_viscosity != 0, corrected = terms.artificial_stress != 0;
    if (viscous && corrected) return add(stress, viscosity, tensile);
    if (viscous) return add(stress, viscosity);
    if (corrected) return add(stress, tensile);
    return add(stress);
}

template <int Dim>
std::uint64_t solid_rates(const ParticleView<Dim>& solid, const NeighborList& list, const PairMethod<Dim>& method,
                          ScalarField& density_rate, TupleField<Dim * Dim>& velocity_gradient,
                          DensitySum density_sum) {
    using Sums = SolidRateSums<Dim>;
    const bool by_volume = density_sum == DensitySum::by_volume;
    return sum_pairs(Sums{}, method, solid, solid, list, [&](Index i, const Vec<Sums::outputs>& sum) {
        double rate = sum[0];
        if (by_volume) {  // the trace of G is −Σ_j V_j v_ij·∇W
            rate = 0;
            for (int k = 0; k < Dim; ++k) rate -= solid.density[i] * sum[Sums::G + k * (Dim + 1)];
        }
        density_rate[i] += rate;
        Tensor<Dim> g, m;
        for (int k = 0; k < Dim * Dim; ++k) {
            g(k / Dim, k % Dim) = sum[Sums::G + k];
            m(k / Dim, k % Dim) = sum[Sums::M + k];
        }
        Tensor<Dim> l = Tensor<Dim>::Zero();
        if (m.determinant() > smallest_moment) l = g * m.inverse();
        velocity_gradient.set(i, rows_of<Dim>(l));
    });
}

#define SLUICE_INSTANTIATE(Dim)                                                                                    \
    template std::uint64_t solid_momentum<Dim>(const ParticleView<Dim>&, const NeighborList&, const SolidTerms&,   \
                                               const PairMethod<Dim>&, VectorField<Dim>&);                         \
    template std::uint64_t solid_rates<Dim>(const ParticleView<Dim>&, const NeighborList&, const PairMethod<Dim>&, \
                                            ScalarField&, TupleField<Dim * Dim>&, DensitySum);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
