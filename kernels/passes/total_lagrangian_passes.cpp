#include "kernels/passes/total_lagrangian_passes.hpp"

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/multiphase_loops.hpp"
#include "kernels/passes/total_lagrangian_loops.hpp"
#include "kernels/principal.hpp"

namespace sluice {
namespace {

/// Calls work(of), where of(a) is the constant of particle a: the choice between one for all and one for each body is
/// made once.
template <int Dim, class T, class Work>
std::uint64_t with_constants(const ParticleView<Dim>& particles, std::span<const T> constants, Work&& work) {
    if (constants.size() == 1) {
        const T one = constants.front();
        return work([one](Index) -> const T& { return one; });
    }
    return work([&](Index a) -> const T& { return constants[particles.body[a]]; });
}

}  // namespace

template <int Dim>
std::uint64_t elastic_correction(const ParticleView<Dim>& solid, const NeighborList& list,
                                 std::span<const double> stiffness,
                                 const PairMethod<Dim>& method, SymTensorField<Dim>& gradient_correction,
                                 ScalarField& hourglass_stiffness) {
    using Sums = GradientMatrixSums<Dim>;
    constexpr double smallest_eigenvalue = 0.01;
    return with_constants(solid, stiffness, [&](const auto& stiffness_of) {
      return sum_pairs(Sums{}, method, solid, solid, list, [&](Index a, const Vec<Sums::outputs>& sum) {
        const Tensor<Dim> m = sym_to_tensor<Dim>(sum);
        const bool defined = principal_values<Dim>(m)[0] >= smallest_eigenvalue;
        const Tensor<Dim> l = defined ? Tensor<Dim>(m.inverse()) : Tensor<Dim>(Tensor<Dim>::Zero());
        gradient_correction.set(a, tensor_to_sym<Dim>(l));
        hourglass_stiffness[a] = defined ? stiffness_of(a) : 0.0;
      });
    });
}

template <int Dim>
std::uint64_t elastic_deformation(const ParticleView<Dim>& solid, const NeighborList& list,
                                  std::span<const Hyperelastic> laws, const PairMethod<Dim>& method, TupleField<Dim * Dim>& deformation,
                                  TupleField<Dim * Dim>& corrected_stress) {
    return with_constants(solid, laws, [&](const auto& law_of) {
      return sum_pairs(DeformationSums<Dim>{}, method, solid, solid, list, [&](Index a, const Vec<Dim * Dim>& sum) {
        const Tensor<Dim> l = sym_to_tensor<Dim>(at(solid.gradient_correction, a));
        const Tensor<Dim> f = l(0, 0) > 0 ? Tensor<Dim>(tensor_of<Dim>(sum) * l) : Tensor<Dim>(Tensor<Dim>::Identity());
        const double share = solid.elastic_share ? solid.elastic_share[a] : 1.0;
        const Tensor<Dim> t = share * law_of(a).template first_piola_stress<Dim>(f) * l - solid.hourglass_stiffness[a] * f;
        deformation.set(a, rows_of<Dim>(f));
        corrected_stress.set(a, rows_of<Dim>(t));
      });
    });
}

template <int Dim>
std::uint64_t elastic_momentum(const ParticleView<Dim>& solid, const NeighborList& list,
                               const ElasticViscosity& viscosity, const PairMethod<Dim>& method,
                               VectorField<Dim>& acceleration) {
    const auto add = [&](const auto& pass) {
        return sum_pairs(pass, method, solid, solid, list, [&](Index a, const Vec<Dim>& sum) {
            acceleration.set(a, acceleration[a] + (solid.volume[a] / solid.mass[a]) * sum);
        });
    };
    if (viscosity.artificial_viscosity == 0) return add(ElasticMomentum<Dim>{});
    if (viscosity.multiphase) return add(MultiphaseElasticMomentum<Dim>{{viscosity.artificial_viscosity}});
    const double coefficient = viscosity.artificial_viscosity * viscosity.density * viscosity.sound_speed;
    return add(ElasticMomentum<Dim, ReferenceViscosity>{{coefficient}});
}

template <int Dim>
std::uint64_t hourglass_energy(const ParticleView<Dim>& solid, const NeighborList& list, const PairMethod<Dim>& method,
                               ScalarField& energy) {
    return sum_pairs(HourglassErrors<Dim>{}, method, solid, solid, list, [&](Index a, const Vec<1>& sum) {
        energy[a] = 0.5 * solid.hourglass_stiffness[a] * solid.volume[a] * sum[0];
    });
}

#define SLUICE_INSTANTIATE(Dim)                                                                                       \
    template std::uint64_t elastic_correction<Dim>(const ParticleView<Dim>&, const NeighborList&, std::span<const double>,             \
                                                   const PairMethod<Dim>&, SymTensorField<Dim>&, ScalarField&);       \
    template std::uint64_t elastic_deformation<Dim>(const ParticleView<Dim>&, const NeighborList&,                    \
                                                    std::span<const Hyperelastic>, const PairMethod<Dim>&,                      \
                                                    TupleField<Dim * Dim>&, TupleField<Dim * Dim>&);                  \
    template std::uint64_t elastic_momentum<Dim>(const ParticleView<Dim>&, const NeighborList&,                       \
                                                 const ElasticViscosity&, const PairMethod<Dim>&, VectorField<Dim>&); \
    template std::uint64_t hourglass_energy<Dim>(const ParticleView<Dim>&, const NeighborList&,                       \
                                                 const PairMethod<Dim>&, ScalarField&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
