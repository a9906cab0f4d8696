#include "engine/step/clamp_extension.hpp"

#include <limits>
#include <optional>

#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

template <int Dim>
Point point_of(const Vec<Dim>& x) {
    Point p{};
    for (int k = 0; k < Dim; ++k) p[static_cast<std::size_t>(k)] = x[k];
    return p;
}

/// Where the clamp's surface cuts the way from a held particle to a free one. If the clamp holds the place of the free
/// one too, which belongs to another body then, half-way.
template <int Dim>
Vec<Dim> surface_point(const Shape& clamp, const Vec<Dim>& held, const Vec<Dim>& free) {
    if (clamp.contains(point_of(free))) return 0.5 * (held + free);
    double inside = 0, outside = 1;
    for (int n = 0; n < std::numeric_limits<double>::digits; ++n) {
        const double middle = 0.5 * (inside + outside);
        (clamp.contains(point_of(held + middle * (free - held))) ? inside : outside) = middle;
    }
    return held + 0.5 * (inside + outside) * (free - held);
}

/// The place in `among` of the particle nearest to x of those at least `least` away from `from`.
template <int Dim>
std::optional<Index> nearest(const VectorField<Dim>& position, const Array<Index>& among, const Vec<Dim>& x,
                             const Vec<Dim>& from, double least) {
    std::optional<Index> found;
    double best = std::numeric_limits<double>::max();
    for (const Index j : among) {
        const double distance = norm2(position[j] - x);
        if (distance >= best || norm(position[j] - from) < least) continue;
        found = j;
        best = distance;
    }
    return found;
}

/// Whether free particles stand within `support` on the side of x that is turned away from `free`.
template <int Dim>
bool free_behind(const VectorField<Dim>& position, const Array<Index>& among, const Vec<Dim>& x, const Vec<Dim>& free,
                 double support) {
    // Behind: more than 120 degrees off, so that a clamp's convex edge, seen from inside it, is no second side.
    constexpr double behind = -0.5;
    const Vec<Dim> ahead = (1 / norm(free - x)) * (free - x);
    for (const Index j : among) {
        const Vec<Dim> to = position[j] - x;
        const double distance = norm(to);
        if (distance < support && dot(ahead, to) < behind * distance) return true;
    }
    return false;
}

}  // namespace

template <int Dim>
ClampExtension<Dim>::ClampExtension(const Scene& scene, const SolidPhase<Dim>& solid, const NeighborList& list,
                                    double support) {
    const std::size_t n = solid.owned;
    extended_.assign(n, 0);
    rigid_.resize(n);
    Array<std::uint8_t> free(n), held(n), near_free(n), near_held(n);
    for (std::size_t i = 0; i < n; ++i) held[i] = solid.clamped[i], free[i] = !solid.clamped[i];
    list.mark_candidates(free, near_free);
    list.mark_candidates(held, near_held);
    Array<Index> behind, ahead;
    for (std::size_t i = 0; i < n; ++i) {
        rigid_[i] = held[i] && !near_free[i];
        if (held[i] && near_free[i]) behind.push_back(static_cast<Index>(i));
        if (free[i] && near_held[i]) ahead.push_back(static_cast<Index>(i));
    }
    // In the reference configuration, where bodies that are not joined are out of each other's reach.
    const auto& place = solid.reference_position;
    Array<Pair> pairs(behind.size());
    parallel_for(behind.size(), [&](std::size_t k) {
        const Index b = behind[k];
        const Vec<Dim> x = place[b], to_scene = solid.position[b] - x;
        const auto next = nearest<Dim>(place, ahead, x, x, 0);
        rigid_[b] = !next || norm(place[*next] - x) > support;  // marked by its cluster only
        if (rigid_[b]) return;
        if (free_behind<Dim>(place, ahead, x, place[*next], support)) return;
        const Shape& clamp = *scene.bodies[solid.body[b]].clamp;
        const Vec<Dim> at = surface_point<Dim>(clamp, x + to_scene, place[*next] + to_scene) - to_scene;
        const double depth = norm(x - at);
        constexpr double rounding = 1e-6;  // above the slack that closes shapes, which is relative to their size
        const auto image = nearest<Dim>(place, ahead, 2.0 * at - x, at, depth * (1 - rounding));
        if (!image) return;
        extended_[b] = rigid_[b] = 1;
        pairs[k] = {b, *image, depth / norm(place[*image] - at), solid.position[b], solid.position[*image]};
    });
    for (std::size_t k = 0; k < behind.size(); ++k)
        if (extended_[behind[k]]) pair_.push_back(pairs[k]);
}

template <int Dim>
void ClampExtension<Dim>::take_energy(SolidPhase<Dim>& solid) const {
    for (std::size_t i = 0; i < rigid_.size(); ++i) {
        if (!rigid_[i]) continue;
        solid.gradient_correction.set(i, {});
        solid.hourglass_stiffness[i] = 0;
    }
}

template <int Dim>
void ClampExtension<Dim>::displace(SolidPhase<Dim>& solid) const {
    for (const Pair& p : pair_) {
        solid.position.set(p.behind, p.start - p.ratio * (solid.position[p.of] - p.start_of));
        solid.velocity.set(p.behind, -p.ratio * solid.velocity[p.of]);
    }
}

template <int Dim>
void ClampExtension<Dim>::hand_over(SolidPhase<Dim>& solid) const {
    for (const Pair& p : pair_) {
        const double share = p.ratio * solid.mass[p.behind] / solid.mass[p.of];
        solid.acceleration.set(p.of, solid.acceleration[p.of] - share * solid.acceleration[p.behind]);
        solid.acceleration.set(p.behind, {});
    }
    put_back(solid);
}

template <int Dim>
void ClampExtension<Dim>::put_back(SolidPhase<Dim>& solid) const {
    for (const Pair& p : pair_) {
        solid.velocity.set(p.behind, {});
        solid.position.set(p.behind, p.start);
    }
}

template class ClampExtension<2>;
template class ClampExtension<3>;

}  // namespace sluice
