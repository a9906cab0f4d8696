#include "engine/step/parts/clamp_extension.hpp"

#include <cmath>
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

/// The distance from x to a clamp's surface in the direction `ahead`; negative if x lies outside and the surface is
/// behind it. Searches over `reach` on either side; if a clamp holds all of that, as that of another body may, the
/// result is half-way to what is ahead.
template <int Dim>
std::optional<double> depth_below_surface(const Shape& clamp, const Vec<Dim>& x, const Vec<Dim>& ahead, double reach) {
    const auto holds = [&](double t) { return clamp.contains(point_of(x + t * ahead)); };
    const bool held = holds(0);
    double inside = held ? 0 : -reach, outside = held ? reach : 0;
    if (holds(outside)) return reach / 2;
    if (!holds(inside)) return {};
    for (int n = 0; n < std::numeric_limits<double>::digits; ++n) {
        const double middle = 0.5 * (inside + outside);
        (holds(middle) ? inside : outside) = middle;
    }
    return 0.5 * (inside + outside);
}

/// The fraction of a particle's cell, a cube of this side around x, that lies outside a clamp.
template <int Dim>
double share_outside(const Shape& clamp, const Vec<Dim>& x, double side) {
    const auto share = [&](int per_side, double reach) {  // of points spread evenly over a cube of side 2 reach
        int all = 1, outside = 0;
        for (int k = 0; k < Dim; ++k) all *= per_side;
        for (int n = 0; n < all; ++n) {
            Vec<Dim> p = x;
            for (int k = 0, rest = n; k < Dim; ++k, rest /= per_side)
                p[k] += reach * ((2 * (rest % per_side) + 1.0) / per_side - 1);
            outside += !clamp.contains(point_of(p));
        }
        return static_cast<double>(outside) / all;
    };
    // Corners, their middles and the centre: one surface that leaves all of them on one side leaves the cell whole.
    const double coarse = share(3, 0.75 * side);
    if (coarse == 0 || coarse == 1) return coarse;
    constexpr int fine = Dim == 2 ? 64 : 24;
    return share(fine, 0.5 * side);
}

/// The place in `among` of the particle nearest to x, of those at least `least` away from `from`.
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
ClampExtension<Dim>::ClampExtension(const Scene& scene, ParticleSet<Dim>& solid, const NeighborList& list,
                                    double support) {
    const std::size_t n = solid.owned;
    extended_.assign(n, 0);
    rigid_.resize(n);
    share_.resize(n);
    const auto clamp_of = [&](std::size_t i) -> const auto& { return scene.bodies[solid.body[i]].clamp; };
    parallel_for(n, [&](std::size_t i) {
        const double side = std::pow(solid.volume[i], 1.0 / Dim);
        share_[i] = clamp_of(i) ? share_outside<Dim>(*clamp_of(i), solid.position[i], side) : 1;
    });
    Array<std::uint8_t> elastic(n), followers(n), reached(n), near(n), twice_as_near(n);
    for (std::size_t i = 0; i < n; ++i) {
        followers[i] = solid.clamped[i] || share_[i] < 1;
        elastic[i] = share_[i] > 0;
    }
    list.mark_candidates(elastic, reached);
    list.mark_candidates(followers, near);
    list.mark_candidates(near, twice_as_near);  // what lies a support deep has its image as far out
    Array<Index> behind, ahead, sources;
    for (std::size_t i = 0; i < n; ++i) {
        rigid_[i] = followers[i] && !reached[i];
        if (followers[i] && reached[i]) behind.push_back(static_cast<Index>(i));
        if (!followers[i] && twice_as_near[i]) ahead.push_back(static_cast<Index>(i));
        if (elastic[i] && near[i]) sources.push_back(static_cast<Index>(i));
    }
    // In the reference configuration, where bodies that are not joined are out of each other's reach.
    const auto& place = solid.reference_position;
    Array<Pair> pairs(behind.size());
    parallel_for(behind.size(), [&](std::size_t k) {
        const Index b = behind[k];
        const Vec<Dim> x = place[b];
        const auto source = nearest<Dim>(place, sources, x, x, 0);
        const auto next = nearest<Dim>(place, ahead, x, x, 0);
        rigid_[b] =
            solid.clamped[b] && (!next || !source || norm(place[*source] - x) > support);  // only its cluster is
        if (rigid_[b] || !next || free_behind<Dim>(place, ahead, x, place[*next], support)) return;
        const double reach = norm(place[*next] - x);
        const Vec<Dim> forward = (1 / reach) * (place[*next] - x);
        const auto depth = depth_below_surface<Dim>(*clamp_of(b), solid.position[b], forward, reach);
        if (!depth) return;
        const Vec<Dim> at = x + *depth * forward;
        // An image nearer than that would move what follows it by much more than itself.
        constexpr double least = 0.61;
        const auto image = nearest<Dim>(place, ahead, at + std::abs(*depth) * forward, at, least * std::abs(*depth));
        if (!image) return;
        extended_[b] = 1;
        rigid_[b] = share_[b] == 0;
        pairs[k] = {b, *image, *depth / norm(place[*image] - at), solid.position[b], solid.position[*image]};
    });
    for (std::size_t k = 0; k < behind.size(); ++k)
        if (extended_[behind[k]]) pair_.push_back(pairs[k]);
    for (std::size_t i = 0; i < n; ++i) {
        if (rigid_[i]) share_[i] = 0;
        if (extended_[i]) solid.clamped[i] = 1;
        if (solid.clamped[i] && !rigid_[i] && !extended_[i]) share_[i] = 1;
    }
}

template <int Dim>
void ClampExtension<Dim>::share_energy(ParticleSet<Dim>& solid) const {
    for (std::size_t i = 0; i < share_.size(); ++i) {
        solid.elastic_share[i] = share_[i];
        solid.hourglass_stiffness[i] *= share_[i];
        if (share_[i] == 0) solid.gradient_correction.set(i, {});
    }
}

template <int Dim>
void ClampExtension<Dim>::displace(ParticleSet<Dim>& solid) const {
    for (const Pair& p : pair_) {
        solid.position.set(p.behind, p.start - p.ratio * (solid.position[p.of] - p.start_of));
        solid.velocity.set(p.behind, -p.ratio * solid.velocity[p.of]);
    }
}

template <int Dim>
void ClampExtension<Dim>::hand_over(ParticleSet<Dim>& solid) const {
    for (const Pair& p : pair_) {
        const double share = p.ratio * solid.mass[p.behind] / solid.mass[p.of];
        solid.acceleration.set(p.of, solid.acceleration[p.of] - share * solid.acceleration[p.behind]);
        solid.acceleration.set(p.behind, {});
    }
    put_back(solid);
}

template <int Dim>
void ClampExtension<Dim>::put_back(ParticleSet<Dim>& solid) const {
    for (const Pair& p : pair_) {
        solid.velocity.set(p.behind, {});
        solid.position.set(p.behind, p.start);
    }
}

template class ClampExtension<2>;
template class ClampExtension<3>;

}  // namespace sluice
