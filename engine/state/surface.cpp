#include "engine/state/surface.hpp"

#include <algorithm>
#include <cmath>

#include "engine/state/surface_chain.hpp"

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

}  // namespace

void SurfaceChains::add_body(const Packing& packing, Index first_id, std::uint16_t body) {
    const double half_spacing = 0.5 * std::sqrt(packing.spacing[0] * packing.spacing[1]);
    for (auto& loop : trace_outline(packing.site)) {
        for (Index& id : loop) id += first_id;
        chains_.push_back({std::move(loop), half_spacing, body});
    }
}

std::size_t SurfaceChains::element_count() const {
    std::size_t n = 0;
    for (const Chain& chain : chains_) n += chain.ids.size();
    return n;
}

void SurfaceChains::allocate(InterfaceElements<2>& elements) const {
    const std::size_t n = element_count();
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
    for (const Chain& chain : chains_) elements.body.insert(elements.body.end(), chain.ids.size(), chain.body);
}

void SurfaceChains::update(const VectorField<2>& position, const std::vector<Index>& index_of_id,
                           InterfaceElements<2>& elements) const {
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

}  // namespace sluice
