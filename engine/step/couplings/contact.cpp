#include "engine/step/couplings/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/files/state_visitors.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

template <int Dim>
ParticleView<Dim> view_of(const ContactParticles<Dim>& p) {
    ParticleView<Dim> v;
    v.position = columns_of(p.position);
    v.smoothing_length = p.smoothing_length.data();
    v.volume = p.volume.data();
    v.pressure = p.pressure.data();
    return v;
}

template <int Dim>
void clear(VectorField<Dim>& field) {
    for (ScalarField& column : field.c) std::fill(column.begin(), column.end(), 0.0);
}

}  // namespace

template <int Dim>
SolidContact<Dim>::SolidContact(StepContext<Dim>& context)
    : c_(context), search_(context.state, context.neighbors, context.method.smoothing.support) {
    flat_ = flat_contact<Dim>(c_.method.smoothing, c_.scene.method.smoothing_length);
}

template <int Dim>
void SolidContact<Dim>::start() {
    set_thresholds();
}

template <int Dim>
void SolidContact<Dim>::set_thresholds() {
    auto& solid = c_.state.solid;
    search_.update();
    const auto raise = [&](Particles& p, ScalarField& threshold) {
        threshold.assign(solid.owned, flat_.density);
        for (std::size_t n = 0; n < p.size(); ++n) {
            double& t = threshold[solid.id[p.solid[n]]];
            t = std::max(t, p.density[n]);
        }
        clear(p.force_density);  // it was ∇σ
    };
    body_threshold_.resize(search_.bodies.size());
    for (std::size_t k = 0; k < search_.bodies.size(); ++k) {
        sum_among_bodies(search_.bodies[k]);
        raise(search_.bodies[k].particles, body_threshold_[k]);
    }
    sum_at_walls();
    raise(search_.at_walls, wall_threshold_);
    for (const GhostPlane<Dim>& plane : c_.state.ghost_planes) {
        plane_threshold_.emplace_back();
        if (!plane.is_mirror()) continue;
        ScalarField& z0 = plane_threshold_.back();
        z0.resize(solid.owned);
        for (std::size_t i = 0; i < solid.owned; ++i) {
            const double z = plane.distance(solid.position[i]);
            const double half = 0.5 * solid.smoothing_length[i] / c_.scene.method.smoothing_length;
            z0[solid.id[i]] = z > 0 ? std::min(z, half) : -std::numeric_limits<double>::infinity();
        }
    }
}

template <int Dim>
void SolidContact<Dim>::push_solid(const PartRange& part) {
    {
        const auto scope = c_.timer.measure(StepPhase::search);
        search_.update();
    }
    const auto scope = c_.timer.measure(StepPhase::contact_pass);
    for (std::size_t k = 0; k < search_.bodies.size(); ++k) push_among_bodies(k, part);
    push_at_walls(part);
    push_at_planes(part);
}

template <int Dim>
void SolidContact<Dim>::refresh(Particles& p) {
    const auto& solid = c_.state.solid;
    parallel_for(p.size(), [&](std::size_t n) {
        p.position.set(n, solid.position[p.solid[n]]);
        p.density[n] = p.pressure[n] = 0;
    });
    clear(p.force_density);
}

template <int Dim>
void SolidContact<Dim>::sum_among_bodies(Bodies& contact) {
    Particles& p = contact.particles;
    refresh(p);
    for (const NeighborList& list : contact.lists)
        c_.pairs += contact_sums<Dim>(view_of(p), view_of(p), list, c_.method, p.density, p.force_density);
}

template <int Dim>
void SolidContact<Dim>::sum_at_walls() {
    Particles& p = search_.at_walls;
    refresh(p);
    if (p.size() == 0) return;
    c_.pairs += contact_sums<Dim>(view_of(p), sluice::view_of(c_.state.wall), search_.wall_list, c_.method, p.density,
                                  p.force_density);
}

template <int Dim>
template <class Stiffness>
bool SolidContact<Dim>::set_pressure(Particles& p, const ScalarField& threshold, Stiffness&& stiffness) {
    const auto& id = c_.state.solid.id;
    return nonnegative_max(p.size(), [&](std::size_t n) {
               const Index i = p.solid[n];
               return p.pressure[n] = stiffness(i) * std::max(p.density[n] - threshold[id[i]], 0.0);
           }) != 0;  // NaN too
}

template <int Dim>
double SolidContact<Dim>::wall_stiffness(std::size_t i) const {
    return contact_stiffness * c_.state.solid_materials.of_body(c_.state.solid.body[i]).law.wave_modulus();
}

template <int Dim>
void SolidContact<Dim>::push_among_bodies(std::size_t number, const PartRange& part) {
    Bodies& contact = search_.bodies[number];
    Particles& p = contact.particles;
    if (contact.lists.empty()) return;
    sum_among_bodies(contact);
    const double stiffness = contact_stiffness * contact.modulus;
    const bool touching = set_pressure(p, body_threshold_[number], [stiffness](Index) { return stiffness; });
    clear(p.force_density);
    if (!touching) return;
    for (const NeighborList& list : contact.lists)
        c_.pairs += contact_force<Dim>(view_of(p), view_of(p), list, c_.method, p.force_density);
    accelerate(p, part);
}

template <int Dim>
void SolidContact<Dim>::push_at_walls(const PartRange& part) {
    Particles& p = search_.at_walls;
    if (search_.wall_list.blocks() == 0) return;
    sum_at_walls();
    set_pressure(p, wall_threshold_, [this](Index i) { return wall_stiffness(i); });
    parallel_for(p.size(), [&](std::size_t n) { p.force_density.set(n, -2 * p.pressure[n] * p.force_density[n]); });
    accelerate(p, part);
}

template <int Dim>
void SolidContact<Dim>::accelerate(const Particles& p, const PartRange& part) {
    auto& solid = c_.state.solid;
    parallel_for(p.size(), [&](std::size_t n) {
        const Index i = p.solid[n];
        if (!part.holds(i)) return;
        solid.acceleration.set(i, solid.acceleration[i] + (p.volume[n] / solid.mass[i]) * p.force_density[n]);
    });
}

template <int Dim>
double SolidContact<Dim>::depth(std::size_t plane, std::size_t i) const {
    const auto& solid = c_.state.solid;
    if (plane_threshold_[plane].empty()) return 0;  // a side of a periodic box
    const double z = c_.state.ghost_planes[plane].distance(solid.position[i]);
    return std::max(plane_threshold_[plane][solid.id[i]] - z, 0.0);
}

template <int Dim>
double SolidContact<Dim>::plane_stiffness(std::size_t i) const {
    const auto& solid = c_.state.solid;
    const double volume = solid.mass[i] / c_.state.solid_materials.of_body(solid.body[i]).eos.density;
    const double spacing = solid.smoothing_length[i] / c_.scene.method.smoothing_length;
    const double slope = flat_.slope / spacing;
    return 2 * wall_stiffness(i) * volume * slope * slope;
}

template <int Dim>
void SolidContact<Dim>::push_at_planes(const PartRange& part) {
    auto& solid = c_.state.solid;
    for (std::size_t p = 0; p < search_.at_planes.size(); ++p) {
        const Array<Index>& near = search_.at_planes[p];
        const Vec<Dim> normal = c_.state.ghost_planes[p].normal;
        parallel_for(near.size(), [&](std::size_t n) {
            const Index i = near[n];
            if (!part.holds(i)) return;
            const double force = plane_stiffness(i) * depth(p, i);
            solid.acceleration.set(i, solid.acceleration[i] + (force / solid.mass[i]) * normal);
        });
    }
}

template <int Dim>
double SolidContact<Dim>::energy() const {
    double sum = 0;
    for (const Bodies& contact : search_.bodies) {
        const Particles& p = contact.particles;
        sum += ordered_sum<double>(
                   p.size(), [&](std::size_t n) { return p.volume[n] * p.pressure[n] * p.pressure[n]; }) /
               (2 * contact_stiffness * contact.modulus);
    }
    const Particles& p = search_.at_walls;
    const MaterialList& materials = c_.state.solid_materials;
    const auto at_wall = [&](std::size_t n) { return p.volume[n] * p.pressure[n] * p.pressure[n]; };
    const auto stiffness = [](const MaterialConstants& m) { return contact_stiffness * m.law.wave_modulus(); };
    if (materials.uniform())
        sum += ordered_sum<double>(p.size(), at_wall) / stiffness(materials.front());
    else
        sum += ordered_sum<double>(
            p.size(), [&](std::size_t n) { return at_wall(n) / stiffness(materials.of_body(p.body[n])); });
    const std::size_t owned = c_.state.solid.owned;  // all: they may have changed their places in memory since
    for (std::size_t plane = 0; plane < plane_threshold_.size(); ++plane)
        sum += ordered_sum<double>(owned, [&](std::size_t i) {
            const double z = depth(plane, i);
            return 0.5 * plane_stiffness(i) * z * z;
        });
    return sum;
}

template <int Dim>
Vec<Dim> SolidContact<Dim>::contact_force_on(std::size_t body) const {
    const auto& solid = c_.state.solid;
    Vec<Dim> sum;
    const auto add = [&](const Particles& p) {
        for (std::size_t n = 0; n < p.size(); ++n)
            if (p.body[n] == body) sum += p.volume[n] * p.force_density[n];
    };
    for (const Bodies& contact : search_.bodies) add(contact.particles);
    add(search_.at_walls);
    for (std::size_t p = 0; p < plane_threshold_.size(); ++p)
        for (std::size_t i = 0; i < solid.owned; ++i)
            if (solid.body[i] == body) sum += plane_stiffness(i) * depth(p, i) * c_.state.ghost_planes[p].normal;
    return sum;
}

template <int Dim>
std::size_t SolidContact<Dim>::bytes() const {
    std::size_t reals = wall_threshold_.capacity();
    for (const ScalarField& threshold : body_threshold_) reals += threshold.capacity();
    for (const ScalarField& z0 : plane_threshold_) reals += z0.capacity();
    return reals * sizeof(double) + search_.bytes();
}

template <int Dim>
void SolidContact<Dim>::save(const StateWriter& writer) {
    writer("contact_search", search_);
}
template <int Dim>
void SolidContact<Dim>::restore(const StateReader& reader) {
    reader("contact_search", search_);
}

template class SolidContact<2>;
template class SolidContact<3>;

}  // namespace sluice
