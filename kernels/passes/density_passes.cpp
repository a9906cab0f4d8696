#include "kernels/passes/density_passes.hpp"

#include "kernels/pairs/pair_sum.hpp"
#include "kernels/passes/density_loops.hpp"
#include "kernels/passes/fluid_passes.hpp"
#include "kernels/passes/multiphase_loops.hpp"
#include "kernels/tensor.hpp"

namespace sluice {

template <int Dim>
std::uint64_t diffusive_continuity(const ParticleView<Dim>& fluid, const NeighborList& list,
                                   const DiffusionTerms<Dim>& terms, const PairMethod<Dim>& method,
                                   ScalarField& density_rate) {
    const auto add = [&](const auto& diffusion) {
        const DiffusiveDensityRate<Dim, std::decay_t<decltype(diffusion)>> rate{diffusion};
        return add_scalars(rate, method, fluid, fluid, list, density_rate);
    };
    const double strength = terms.coefficient * terms.sound_speed;
    const double slope = terms.density / (terms.sound_speed * terms.sound_speed);  // dρ/dx of rest, over g
    switch (strength == 0 ? DensityDiffusion::none : terms.kind) {
        case DensityDiffusion::molteni_colagrossi:
            return add(StratifiedDiffusion<Dim>{strength, {}});
        case DensityDiffusion::fourtakas:
            return add(StratifiedDiffusion<Dim>{strength, slope * terms.gravity});
        case DensityDiffusion::antuono:
            return add(GradientDiffusion{strength});
        case DensityDiffusion::none:
            break;
    }
    return continuity(fluid, list, method, density_rate);
}

template <int Dim>
std::uint64_t multiphase_continuity(const ParticleView<Dim>& fluid, const NeighborList& list, double coefficient,
                                    const PairMethod<Dim>& method, ScalarField& density_rate) {
    return add_scalars(MultiphaseDensityRate<Dim>{{coefficient}}, method, fluid, fluid, list, density_rate);
}

template <int Dim>
std::uint64_t density_gradient(const ParticleView<Dim>& fluid, const NeighborList& list, const PairMethod<Dim>& method,
                               VectorField<Dim>& gradient) {
    using Sums = DensityGradientSums<Dim>;
    return sum_pairs(Sums{}, method, fluid, fluid, list, [&](Index i, const Vec<Sums::outputs>& sum) {
        Eigen::Matrix<double, Dim, 1> slope = Eigen::Matrix<double, Dim, 1>::Zero();
        Vec<sym_components<Dim>> packed;
        for (int k = 0; k < sym_components<Dim>; ++k) packed[k] = sum[Dim + k];
        const Tensor<Dim> m = sym_to_tensor<Dim>(packed);
        if (m.determinant() > smallest_moment) {
            for (int k = 0; k < Dim; ++k) slope[k] = sum[k];
            slope = (m.inverse() * slope).eval();
        }
        Vec<Dim> g;
        for (int k = 0; k < Dim; ++k) g[k] = slope[k];
        gradient.set(i, g);
    });
}

#define SLUICE_INSTANTIATE(Dim)                                                                          \
    template std::uint64_t diffusive_continuity<Dim>(const ParticleView<Dim>&, const NeighborList&,      \
                                                     const DiffusionTerms<Dim>&, const PairMethod<Dim>&, \
                                                     ScalarField&);                                      \
    template std::uint64_t multiphase_continuity<Dim>(const ParticleView<Dim>&, const NeighborList&, double, \
                                                      const PairMethod<Dim>&, ScalarField&);              \
    template std::uint64_t density_gradient<Dim>(const ParticleView<Dim>&, const NeighborList&,          \
                                                 const PairMethod<Dim>&, VectorField<Dim>&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
