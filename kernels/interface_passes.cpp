#include "kernels/interface_passes.hpp"

#include "kernels/pair.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// W(|x|, h)
template <int Dim, class Real>
Real kernel_at(const Vec<Dim, Real>& x, Real h) {
    using Smoothing = DefaultSmoothing<Dim>;
    const Real inverse_h = Real(1) / h;
    return kernel_scale<Smoothing, Dim>(inverse_h) * Smoothing::shape(norm(x) * inverse_h);
}

template <int Dim, class Real>
double kernel_between(const std::array<const double*, Dim>& a, Index i, const std::array<const double*, Dim>& b,
                      Index j, double h) {
    const Vec<Dim> x = at<double>(a, i) - at<double>(b, j);
    if (norm2(x) >= 4 * h * h) return 0;  // in the list by its skin only
    return static_cast<double>(kernel_at(vec_cast<Real>(x), static_cast<Real>(h)));
}

/// An element or a particle beside one has some twenty partners: few of them are worth a second thread.
constexpr std::size_t interface_threshold = 128;

template <class Body>
void for_elements(std::size_t n, Body&& body) {
    const auto count = static_cast<std::int64_t>(n);
#pragma omp parallel for schedule(static) if (n > interface_threshold)
    for (std::int64_t i = 0; i < count; ++i) body(static_cast<std::size_t>(i));
}

/// Σ_k force_of(k, i, neighbours) over the listed particles, in an order that does not depend on the threads.
template <int Dim, class F>
Vec<Dim> sum_over_list(const NeighborList& list, F&& force_of) {
    return ordered_sum<Vec<Dim>, 32>(
        list.groups(), [&](std::size_t l) { return force_of(list.queries(l)[0], list.candidates(l)); },
        interface_threshold);
}

}  // namespace

template <int Dim, class Real>
void interface_pressure(const ElementView<Dim>& elements, const ParticleView<Dim>& fluid, std::size_t owned_fluid,
                        const NeighborList& list, ScalarField& pressure, ScalarField& image_pressure) {
    std::fill(pressure.begin(), pressure.end(), 0.0);
    std::fill(image_pressure.begin(), image_pressure.end(), 0.0);
    for_elements(list.groups(), [&](std::size_t l) {
        const Index k = list.queries(l)[0];
        double total = 0, from_images = 0;
        for (const Index b : list.candidates(l)) {
            const double w =
                kernel_between<Dim, Real>(elements.position, k, fluid.position, b, fluid.smoothing_length[b]);
            const double p = 2 * fluid.mass[b] / fluid.density[b] * fluid.pressure[b] * w;
            total += p;
            if (b >= owned_fluid) from_images += p;
        }
        pressure[k] = total;
        image_pressure[k] = from_images;
    });
}

template <int Dim, class Real>
void interface_weights(const ElementView<Dim>& elements, const ParticleView<Dim>& solid, const NeighborList& list,
                       ScalarField& weight, VectorField<Dim>& velocity) {
    std::fill(weight.begin(), weight.end(), 0.0);
    for_elements(list.groups(), [&](std::size_t l) {
        const Index k = list.queries(l)[0];
        double sum = 0;
        Vec<Dim> v;
        for (const Index a : list.candidates(l)) {
            const double w =
                solid.mass[a] / solid.density[a] *
                kernel_between<Dim, Real>(elements.position, k, solid.position, a, solid.smoothing_length[a]);
            sum += w;
            v += w * at<double>(solid.velocity, a);
        }
        weight[k] = sum;
        velocity.set(k, sum > 0 ? (1 / sum) * v : v);
    });
}

template <int Dim, class Real>
Vec<Dim> interface_force_on_solid(const ParticleView<Dim>& solid, const ElementView<Dim>& elements,
                                  const NeighborList& list, const ScalarField& weight, const VectorField<Dim>& force,
                                  VectorField<Dim>& acceleration) {
    return sum_over_list<Dim>(list, [&](Index a, std::span<const Index> near) {
        Vec<Dim> f;
        const double volume = solid.mass[a] / solid.density[a];
        for (const Index k : near) {
            if (k >= elements.owned) continue;  // an image's force belongs to the image of the solid
            const double w =
                kernel_between<Dim, Real>(elements.position, k, solid.position, a, solid.smoothing_length[a]);
            if (weight[k] > 0) f += (volume * w / weight[k]) * force[k];
        }
        acceleration.set(a, acceleration[a] + (1 / solid.mass[a]) * f);
        return f;
    });
}

template <int Dim, class Real>
Vec<Dim> interface_force_on_fluid(const ParticleView<Dim>& fluid, const ElementView<Dim>& elements,
                                  const NeighborList& list, VectorField<Dim>& acceleration) {
    return sum_over_list<Dim>(list, [&](Index b, std::span<const Index> near) {
        Vec<Dim> real, image;
        const double factor = 2 * fluid.mass[b] / fluid.density[b] * fluid.pressure[b];
        for (const Index k : near) {
            const double w =
                kernel_between<Dim, Real>(elements.position, k, fluid.position, b, fluid.smoothing_length[b]);
            (k < elements.owned ? real : image) += (factor * w) * at<double>(elements.area_normal, k);
        }
        acceleration.set(b, acceleration[b] + (1 / fluid.mass[b]) * (real + image));
        return real;
    });
}

template <int Dim, class Real>
void interface_continuity(const ParticleView<Dim>& fluid, const ElementView<Dim>& elements, const NeighborList& list,
                          ScalarField& density_rate) {
    for_elements(list.groups(), [&](std::size_t l) {
        const Index b = list.queries(l)[0];
        const Vec<Dim> v_b = at<double>(fluid.velocity, b);
        double rate = 0;
        for (const Index k : list.candidates(l)) {
            const double w =
                kernel_between<Dim, Real>(elements.position, k, fluid.position, b, fluid.smoothing_length[b]);
            rate += w * dot(at<double>(elements.area_normal, k), v_b - at<double>(elements.velocity, k));
        }
        density_rate[b] -= 2 * fluid.density[b] * rate;
    });
}

#define SLUICE_INSTANTIATE(Dim, Real)                                                                                  \
    template void interface_pressure<Dim, Real>(const ElementView<Dim>&, const ParticleView<Dim>&, std::size_t,        \
                                                const NeighborList&, ScalarField&, ScalarField&);                      \
    template void interface_weights<Dim, Real>(const ElementView<Dim>&, const ParticleView<Dim>&, const NeighborList&, \
                                               ScalarField&, VectorField<Dim>&);                                       \
    template Vec<Dim> interface_force_on_solid<Dim, Real>(const ParticleView<Dim>&, const ElementView<Dim>&,           \
                                                          const NeighborList&, const ScalarField&,                     \
                                                          const VectorField<Dim>&, VectorField<Dim>&);                 \
    template Vec<Dim> interface_force_on_fluid<Dim, Real>(const ParticleView<Dim>&, const ElementView<Dim>&,           \
                                                          const NeighborList&, VectorField<Dim>&);                     \
    template void interface_continuity<Dim, Real>(const ParticleView<Dim>&, const ElementView<Dim>&,                   \
                                                  const NeighborList&, ScalarField&);
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
