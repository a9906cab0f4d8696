// Images of what stands near mirror walls and the sides of periodic boxes: made with the lists, refreshed before
// passes.
#include <algorithm>

#include "engine/step/neighborhood.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

double largest(const ScalarField& h) { return h.empty() ? 1.0 : *std::max_element(h.begin(), h.end()); }

}  // namespace

/// Brings what has left a periodic box back in at the other side. In between particles may stand outside, as their
/// lists know them there.
template <int Dim>
void Neighborhood<Dim>::wrap_fluid() {
    auto& fluid = state_.fluid;
    for (const GhostPlane<Dim>& plane : state_.ghost_planes) {
        if (plane.is_mirror()) continue;
        parallel_for(fluid.owned, [&](std::size_t i) {
            const Vec<Dim> x = fluid.position[i];
            if (plane.distance(x) < 0) fluid.position.set(i, plane.image_position(x));
        });
    }
}

/// The same for ghosts of walls that have moved along.
template <int Dim>
void Neighborhood<Dim>::wrap_walls() {
    auto& wall = state_.wall;
    for (const GhostPlane<Dim>& plane : state_.ghost_planes) {
        if (plane.is_mirror()) continue;
        const Vec<Dim> shift = plane.shift * plane.normal;
        parallel_for(wall.owned, [&](std::size_t i) {
            if (plane.distance(wall.position[i]) >= 0) return;
            wall.position.set(i, wall.position[i] + shift);
            wall.initial_position.set(i, wall.initial_position[i] + shift);
        });
    }
}

/// Ghosts of a set and the grid that they stand in, for all that is no farther from a plane than range(i). [m]
template <int Dim>
template <class Range>
void Neighborhood<Dim>::make_ghosts(ParticleSet<Dim>& set, Grid& grid, double cell, bool with_reach, Range&& range) {
    set.ghosts.create(state_.ghost_planes, set.position, set.owned, range);
    set.ghosts.template extend<Mirror::same>(set.smoothing_length, set.owned);
    const std::span<const double> reach = with_reach ? std::span<const double>(set.smoothing_length) : std::span<const double>();
    grid.build(set.position, set.owned, set.size(), cell, reach);
    set.ghosts.reorder(grid.order(), set.owned);
    grid.particles_were_sorted(set.owned);
    set.extend_ghosts();
}

template <int Dim>
void Neighborhood<Dim>::make_fluid_images() {
    auto& fluid = state_.fluid;
    // A particle at distance s from the plane has its image at −s; the nearest that can feel it stands on the plane.
    const double farthest = half_support() * state_.max_h + fluid_skin_.skin();
    make_ghosts(fluid, fluid_image_grid_, cell_over_h_ * largest(fluid.smoothing_length), true,
                [&](std::size_t i) { return half_support() * fluid.smoothing_length[i] + farthest; });
}

template <int Dim>
void Neighborhood<Dim>::make_wall_images() {
    if (!has_images()) return;
    auto& wall = state_.wall;
    const double farthest = half_support() * state_.max_h + fluid_skin_.skin();
    make_ghosts(wall, wall_image_grid_, cell_over_h_ * largest(wall.smoothing_length), true,
                [&](std::size_t i) { return half_support() * wall.smoothing_length[i] + farthest; });
}

template <int Dim>
void Neighborhood<Dim>::make_element_images() {
    const double farthest = support_ * state_.max_h + coupling_skin_.skin();
    make_ghosts(state_.elements, element_image_grid_, cell_over_h_ * state_.max_h, false,
                [&](std::size_t) { return farthest; });
}

template <int Dim>
void Neighborhood<Dim>::make_boundary_images() {
    auto& boundary = state_.boundary;
    const double farthest = half_support() * state_.max_h + coupling_skin_.skin();
    make_ghosts(boundary, boundary_image_grid_, cell_over_h_ * state_.max_h, true,
                [&](std::size_t i) { return half_support() * boundary.smoothing_length[i] + farthest; });
}

#define SLUICE_INSTANTIATE(Dim)                             \
    template void Neighborhood<Dim>::wrap_fluid();          \
    template void Neighborhood<Dim>::wrap_walls();          \
    template void Neighborhood<Dim>::make_fluid_images();   \
    template void Neighborhood<Dim>::make_wall_images();    \
    template void Neighborhood<Dim>::make_element_images(); \
    template void Neighborhood<Dim>::make_boundary_images();
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
