#include "engine/particles/surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/particles/surface_chain.hpp"
#include "engine/particles/surface_facets.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// Sharper corners than 120° between normals would throw the vertex far out; there it stays at this multiple of d/2.
constexpr double smallest_cosine = -0.5;

/// Outward unit normal of the edge from a to b, the material on its left.
Vec<2> edge_normal(const Vec<2>& a, const Vec<2>& b) {
    const Vec<2> t = b - a;
    const double length = norm(t);
    return {{t[1] / length, -t[0] / length}};
}

/// Where the two edges at x, shifted outwards by `offset`, meet.
Vec<2> offset_vertex(const Vec<2>& before, const Vec<2>& x, const Vec<2>& after, double offset) {
    const Vec<2> n1 = edge_normal(before, x), n2 = edge_normal(x, after);
    return x + (offset / (1 + std::max(dot(n1, n2), smallest_cosine))) * (n1 + n2);
}

Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

template <int Dim>
void allocate_columns(ParticleSet<Dim>& elements, std::size_t n) {
    elements.owned = n;
    elements.position.resize(n);
    elements.area_normal.resize(n);
    elements.velocity.resize(n);
    elements.force.resize(n);
    elements.shared_force.resize(n);
    elements.pressure.assign(n, 0);
    elements.image_pressure.assign(n, 0);
    elements.solid_weight.assign(n, 0);
    elements.body.clear();
}

template <class T>
std::size_t bytes_of(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

}  // namespace

void BodySurface<2>::add_body(const Packing& packing, Index first_id, std::uint16_t body) {
    const double half_spacing = 0.5 * std::sqrt(packing.spacing[0] * packing.spacing[1]);
    for (auto& loop : trace_outline(packing.site)) {
        for (Index& id : loop) id += first_id;
        chains_.push_back({std::move(loop), half_spacing, body});
    }
}

std::size_t BodySurface<2>::element_count() const {
    std::size_t n = 0;
    for (const Chain& chain : chains_) n += chain.ids.size();
    return n;
}

std::size_t BodySurface<2>::bytes() const {
    std::size_t sum = bytes_of(chains_);
    for (const Chain& chain : chains_) sum += bytes_of(chain.ids);
    return sum;
}

void BodySurface<2>::allocate(ParticleSet<2>& elements) const {
    allocate_columns(elements, element_count());
    for (const Chain& chain : chains_) elements.body.insert(elements.body.end(), chain.ids.size(), chain.body);
}

void BodySurface<2>::update(const VectorField<2>& position, const IdIndex& index_of_id,
                            ParticleSet<2>& elements) {
    std::size_t k = 0;
    for (const Chain& chain : chains_) {
        const std::size_t n = chain.ids.size();
        const auto particle = [&](std::size_t i) { return position[index_of_id[chain.ids[i % n]]]; };
        const auto vertex = [&](std::size_t i) {
            return offset_vertex(particle(i + n - 1), particle(i), particle(i + 1), chain.half_spacing);
        };
        Vec<2> from = vertex(0);
        for (std::size_t i = 0; i < n; ++i, ++k) {
            const Vec<2> to = vertex(i + 1);
            elements.position.set(k, 0.5 * (from + to));
            elements.area_normal.set(k, {{to[1] - from[1], from[0] - to[0]}});
            from = to;
        }
    }
}

void BodySurface<3>::add_body(const Packing& packing, Index first_id, std::uint16_t body) {
    const SurfaceFacets facets = trace_surface(packing.site);
    const auto first_corner = static_cast<Index>(corner_.size());
    for (auto corners : facets.faces) {
        for (Index& c : corners) c += first_corner;
        faces_.push_back({corners, body});
    }
    for (const auto& shares : facets.corners) {
        for (const CornerShare& share : shares) shares_.push_back({first_id + share.particle, share.weight});
        first_share_.push_back(shares_.size());
    }
    corner_.resize(first_corner + facets.corners.size());
}

std::size_t BodySurface<3>::bytes() const {
    return bytes_of(faces_) + bytes_of(shares_) + bytes_of(first_share_) + 3 * corner_.c[0].capacity() * sizeof(double);
}

void BodySurface<3>::allocate(ParticleSet<3>& elements) const {
    allocate_columns(elements, element_count());
    for (const Face& face : faces_) elements.body.push_back(face.body);
}

void BodySurface<3>::update(const VectorField<3>& position, const IdIndex& index_of_id,
                            ParticleSet<3>& elements) {
    parallel_for(corner_.size(), [&](std::size_t c) {
        Vec<3> x;
        for (std::size_t s = first_share_[c]; s < first_share_[c + 1]; ++s)
            x += shares_[s].weight * position[index_of_id[shares_[s].id]];
        corner_.set(c, x);
    });
    parallel_for(faces_.size(), [&](std::size_t k) {
        const auto corner = [&](std::size_t c) { return corner_[faces_[k].corners[c]]; };
        const Vec<3> x0 = corner(0), x1 = corner(1), x2 = corner(2), x3 = corner(3);
        elements.position.set(k, 0.25 * ((x0 + x2) + (x1 + x3)));
        elements.area_normal.set(k, 0.5 * cross(x2 - x0, x3 - x1));
    });
}

}  // namespace sluice
