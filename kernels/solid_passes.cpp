#include "kernels/solid_passes.hpp"

#include "kernels/pair_loop.hpp"
#include "kernels/tensor.hpp"
#include "kernels/terms/artificial_stress.hpp"
#include "kernels/terms/artificial_viscosity.hpp"
#include "kernels/terms/continuity.hpp"
#include "kernels/terms/symmetric_stress.hpp"

namespace sluice {

template <int Dim, class Real>
std::uint64_t solid_momentum(const ParticleView<Dim>& solid, const NeighborList& list, const SolidTerms& terms,
                             VectorField<Dim>& acceleration) {
    using Smoothing = DefaultSmoothing<Dim>;
    const SymmetricStress stress;
    const ArtificialViscosity viscosity{terms.artificial_viscosity, terms.sound_speed};
    const auto tensile = ArtificialStress::with<Smoothing>(terms.h_over_d, terms.artificial_stress_exponent);
    const auto gather = [&](const auto&... pack) {
        return gather_vectors<Real, Smoothing>(solid, solid, list, acceleration, pack...);
    };
    const bool viscous = terms.artificial_viscosity != 0, corrected = terms.artificial_stress != 0;
    if (viscous && corrected) return gather(stress, viscosity, tensile);
    if (viscous) return gather(stress, viscosity);
    if (corrected) return gather(stress, tensile);
    return gather(stress);
}

template <int Dim, class Real>
std::uint64_t solid_rates(const ParticleView<Dim>& solid, const NeighborList& list, ScalarField& density_rate,
                          TupleField<Dim * Dim>& velocity_gradient) {
    constexpr double smallest_determinant = 1e-3;
    constexpr int G = 1, M = 1 + Dim * Dim;  // where G and M begin in a pair's outputs; dρ/dt is first
    constexpr unsigned reads_i = column::velocity, reads_j = reads_i | column::mass | column::density;
    return sum_pairs<DefaultSmoothing<Dim>, reads_i, reads_j, M + Dim * Dim, Real>(
        solid, solid, list,
        [](const auto& ij) {
            const Vec<Dim, Real> v_ij = ij.v_ij(), m_grad_w = ij.m_j() * ij.grad_w();
            const Vec<Dim, Real> v_grad_w = (Real(1) / ij.rho_j()) * m_grad_w;
            Vec<M + Dim * Dim, Real> out;
            out[0] = dot(v_ij, m_grad_w);
            unroll<Dim * Dim>([&](int k) {
                out[G + k] = -v_ij[k / Dim] * v_grad_w[k % Dim];
                out[M + k] = -ij.x_ij[k / Dim] * v_grad_w[k % Dim];
            });
            return out;
        },
        [&](Index i, const Vec<M + Dim * Dim>& sum) {
            density_rate[i] += sum[0];
            Tensor<Dim> g, m;
            for (int k = 0; k < Dim * Dim; ++k) {
                g(k / Dim, k % Dim) = sum[G + k];
                m(k / Dim, k % Dim) = sum[M + k];
            }
            Tensor<Dim> l = Tensor<Dim>::Zero();
            if (m.determinant() > smallest_determinant) l = g * m.inverse();
            Vec<Dim * Dim> packed;
            for (int k = 0; k < Dim * Dim; ++k) packed[k] = l(k / Dim, k % Dim);
            velocity_gradient.set(i, packed);
        });
}

#define SLUICE_INSTANTIATE(Dim, Real)                                                                                  \
    template std::uint64_t solid_momentum<Dim, Real>(const ParticleView<Dim>&, const NeighborList&, const SolidTerms&, \
                                                     VectorField<Dim>&);                                               \
    template std::uint64_t solid_rates<Dim, Real>(const ParticleView<Dim>&, const NeighborList&, ScalarField&,         \
                                                  TupleField<Dim * Dim>&);
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
