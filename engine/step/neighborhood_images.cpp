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
    for (const ImagePlane<Dim>& plane : state_.image_planes) {
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
    for (const ImagePlane<Dim>& plane : state_.image_planes) {
        if (plane.is_mirror()) continue;
        const Vec<Dim> shift = plane.shift * plane.normal;
        parallel_for(wall.owned, [&](std::size_t i) {
            if (plane.distance(wall.position[i]) >= 0) return;
            wall.position.set(i, wall.position[i] + shift);
            wall.initial_position.set(i, wall.initial_position[i] + shift);
        });
    }
}

template <int Dim>
void Neighborhood<Dim>::make_fluid_images() {
    auto& fluid = state_.fluid;
    // A particle at distance s from the plane has its image at −s; the nearest that can feel it stands on the plane.
    const double farthest = half_support() * state_.max_h + fluid_skin_.skin();
    fluid_images_.create(state_.image_planes, fluid.position, fluid.owned,
                         [&](std::size_t i) { return half_support() * fluid.smoothing_length[i] + farthest; });
    const std::size_t n = fluid.position.size();
    fluid_images_.extend(fluid.smoothing_length, fluid.owned);
    fluid_image_grid_.build(fluid.position, fluid.owned, n, cell_over_h_ * largest(fluid.smoothing_length),
                            fluid.smoothing_length);
    fluid_images_.reorder(fluid_image_grid_.order(), fluid.owned);
    fluid_image_grid_.particles_were_sorted(fluid.owned);
    for (ScalarField* column :
         {&fluid.density, &fluid.mass, &fluid.smoothing_length, &fluid.pressure, &fluid.pressure_over_rho2})
        fluid_images_.extend(*column, fluid.owned);
    fluid.velocity.resize(n);
    if (effects_.has(Effect::density_gradient)) fluid.density_gradient.resize(n);
    if (effects_.has(Effect::excess_density)) fluid_images_.extend(fluid.excess_density, fluid.owned);
    refresh_fluid_positions();
    refresh_fluid_velocities();
}

template <int Dim>
void Neighborhood<Dim>::make_wall_images() {
    if (!has_images()) return;
    auto& wall = state_.wall;
    const double farthest = half_support() * state_.max_h + fluid_skin_.skin();
    wall_images_.create(state_.image_planes, wall.position, wall.owned,
                        [&](std::size_t i) { return half_support() * wall.smoothing_length[i] + farthest; });
    wall_images_.extend(wall.smoothing_length, wall.owned);
    wall_image_grid_.build(wall.position, wall.owned, wall.position.size(),
                           cell_over_h_ * largest(wall.smoothing_length), wall.smoothing_length);
    wall_images_.reorder(wall_image_grid_.order(), wall.owned);
    wall_image_grid_.particles_were_sorted(wall.owned);
    wall_images_.refresh_positions(wall.position, wall.owned);
    for (ScalarField* column : {&wall.volume, &wall.smoothing_length, &wall.pressure})
        wall_images_.extend(*column, wall.owned);
    if (effects_.has(Effect::no_slip_wall)) {
        wall_images_.extend(wall.friction_volume, wall.owned);
        wall.ghost_velocity.resize(wall.position.size());
    }
    if (!effects_.has(Effect::moving_wall)) return;
    wall.velocity.resize(wall.position.size());
    wall_images_.refresh_directions(wall.velocity, wall.owned);
}

template <int Dim>
void Neighborhood<Dim>::make_element_images() {
    auto& elements = state_.elements;
    const double farthest = support_ * state_.max_h + coupling_skin_.skin();
    element_images_.create(state_.image_planes, elements.position, elements.owned,
                           [&](std::size_t) { return farthest; });
    const std::size_t n = elements.position.size();
    elements.area_normal.resize(n);
    elements.velocity.resize(n);
    elements.shared_force.resize(n);
    element_images_.extend(elements.smoothing_length, elements.owned);
    element_image_grid_.build(elements.position, elements.owned, n, cell_over_h_ * state_.max_h);
    element_images_.reorder(element_image_grid_.order(), elements.owned);
    element_image_grid_.particles_were_sorted(elements.owned);
    refresh_elements();
}

template <int Dim>
void Neighborhood<Dim>::make_boundary_images() {
    auto& boundary = state_.boundary;
    const double farthest = half_support() * state_.max_h + coupling_skin_.skin();
    boundary_images_.create(state_.image_planes, boundary.position, boundary.owned,
                            [&](std::size_t i) { return half_support() * boundary.smoothing_length[i] + farthest; });
    const std::size_t n = boundary.position.size();
    boundary.velocity.resize(n);
    boundary.acceleration.resize(n);
    if (effects_.has(Effect::no_slip_solid)) boundary.ghost_velocity.resize(n);
    for (ScalarField* column : {&boundary.volume, &boundary.smoothing_length})
        boundary_images_.extend(*column, boundary.owned);
    boundary_image_grid_.build(boundary.position, boundary.owned, n, cell_over_h_ * state_.max_h,
                               boundary.smoothing_length);
    boundary_images_.reorder(boundary_image_grid_.order(), boundary.owned);
    boundary_image_grid_.particles_were_sorted(boundary.owned);
    for (ScalarField* column : {&boundary.volume, &boundary.smoothing_length})
        boundary_images_.refresh(*column, boundary.owned);
    refresh_boundary();
}

template <int Dim>
void Neighborhood<Dim>::refresh_boundary() {
    auto& boundary = state_.boundary;
    boundary_images_.refresh_positions(boundary.position, boundary.owned);
    boundary_images_.refresh_directions(boundary.velocity, boundary.owned);
    boundary_images_.refresh_directions(boundary.acceleration, boundary.owned);
    boundary_images_.refresh(boundary.volume, boundary.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_fluid_positions() {
    fluid_images_.refresh_positions(state_.fluid.position, state_.fluid.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_fluid_velocities() {
    fluid_images_.refresh_directions(state_.fluid.velocity, state_.fluid.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_fluid_scalars() {
    for (ScalarField* column : {&state_.fluid.density, &state_.fluid.pressure, &state_.fluid.pressure_over_rho2})
        fluid_images_.refresh(*column, state_.fluid.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_fluid_gradients() {
    fluid_images_.refresh_directions(state_.fluid.density_gradient, state_.fluid.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_fluid_excess() {
    fluid_images_.refresh(state_.fluid.excess_density, state_.fluid.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_fluid_surface() {
    fluid_images_.refresh(state_.fluid.surroundings.surface_volume, state_.fluid.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_elements() {
    auto& elements = state_.elements;
    element_images_.refresh_positions(elements.position, elements.owned);
    element_images_.refresh_directions(elements.area_normal, elements.owned);
    element_images_.refresh_directions(elements.velocity, elements.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_wall_pressure() {
    wall_images_.refresh(state_.wall.pressure, state_.wall.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_wall_motion() {
    wall_images_.refresh_positions(state_.wall.position, state_.wall.owned);
    wall_images_.refresh_directions(state_.wall.velocity, state_.wall.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_wall_friction() {
    auto& wall = state_.wall;
    wall_images_.refresh_directions(wall.ghost_velocity, wall.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_boundary_friction() {
    auto& boundary = state_.boundary;
    boundary_images_.refresh_directions(boundary.ghost_velocity, boundary.owned);
}

#define SLUICE_INSTANTIATE(Dim)                                  \
    template void Neighborhood<Dim>::wrap_fluid();               \
    template void Neighborhood<Dim>::wrap_walls();               \
    template void Neighborhood<Dim>::make_fluid_images();        \
    template void Neighborhood<Dim>::make_wall_images();         \
    template void Neighborhood<Dim>::make_element_images();      \
    template void Neighborhood<Dim>::make_boundary_images();     \
    template void Neighborhood<Dim>::refresh_boundary();         \
    template void Neighborhood<Dim>::refresh_fluid_positions();  \
    template void Neighborhood<Dim>::refresh_fluid_velocities(); \
    template void Neighborhood<Dim>::refresh_fluid_scalars();    \
    template void Neighborhood<Dim>::refresh_fluid_gradients();  \
    template void Neighborhood<Dim>::refresh_fluid_excess();     \
    template void Neighborhood<Dim>::refresh_fluid_surface();    \
    template void Neighborhood<Dim>::refresh_elements();         \
    template void Neighborhood<Dim>::refresh_wall_pressure();    \
    template void Neighborhood<Dim>::refresh_wall_motion();      \
    template void Neighborhood<Dim>::refresh_wall_friction();    \
    template void Neighborhood<Dim>::refresh_boundary_friction();
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
