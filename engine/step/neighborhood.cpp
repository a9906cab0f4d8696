#include "engine/step/neighborhood.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/state/reorder.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// Skin over the smallest smoothing length of its medium. A thicker skin means fewer builds but more to prune; the
/// optimum is flat.
constexpr double skin_over_h = 0.8;

/// Particles in a full cell: 8² or 4³.
constexpr double cell_particles = 64;

double smallest(const ScalarField& h) { return h.empty() ? 1.0 : *std::min_element(h.begin(), h.end()); }
double largest(const ScalarField& h) { return h.empty() ? 1.0 : *std::max_element(h.begin(), h.end()); }

SkinAccount skin_for(const ScalarField& h) { return SkinAccount(skin_over_h * smallest(h), smallest(h)); }

}  // namespace

template <int Dim>
Neighborhood<Dim>::Neighborhood(State<Dim>& state, const Effects& effects, double h_over_d, double support)
    : state_(state),
      effects_(effects),
      cell_over_h_(std::pow(cell_particles, 1.0 / Dim) / h_over_d),
      support_(support),
      fluid_skin_(skin_for(state.fluid.smoothing_length)),
      solid_skin_(skin_for(state.solid.smoothing_length)),
      coupling_skin_(skin_over_h * state.min_h, state.min_h) {
    if (effects.has(Effect::fixed_wall)) sort_walls();
    build_solid();
    build_fluid();
    build_coupling();
}

template <int Dim>
void Neighborhood<Dim>::expect_motion(double of_fluid, double of_solid, double of_solid_substep) {
    fluid_skin_.expect_motion(of_fluid);
    solid_skin_.expect_motion(of_solid_substep);
    coupling_skin_.expect_motion(0.5 * (of_fluid + of_solid));
}

template <int Dim>
void Neighborhood<Dim>::add_motion(double of_fluid, double of_solid) {
    fluid_skin_.add_motion(of_fluid);
    coupling_skin_.add_motion(0.5 * (of_fluid + of_solid));  // elements and particles together: not twice the larger
}

template <int Dim>
void Neighborhood<Dim>::update() {
    bool rebuilt = refresh_solid();
    if (fluid_skin_.outdated()) {
        build_fluid();
        rebuilt = true;
    } else if (fluid_skin_.prune_due())
        prune_fluid();
    if (rebuilt || coupling_skin_.outdated()) build_coupling();
}

template <int Dim>
void Neighborhood<Dim>::update_solid() {
    if (refresh_solid()) build_coupling();
}

/// Returns true if the solid's particles have changed their places in memory.
template <int Dim>
bool Neighborhood<Dim>::refresh_solid() {
    if (state_.solid.owned == 0 || effects_.has(Effect::total_lagrangian)) return false;
    if (solid_skin_.outdated()) {
        build_solid();
        return true;
    }
    if (solid_skin_.prune_due()) prune_solid();
    return false;
}

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

template <int Dim>
void Neighborhood<Dim>::sort_fluid() {
    auto& fluid = state_.fluid;
    fluid_grid_.build(fluid.position, 0, fluid.owned, cell_over_h_ * largest(fluid.smoothing_length),
                      fluid.smoothing_length);
    reorder(fluid, fluid_grid_.order());
    fluid_grid_.particles_were_sorted(0);
}

template <int Dim>
void Neighborhood<Dim>::sort_solid() {
    auto& solid = state_.solid;
    solid_grid_.build(solid.position, 0, solid.owned, cell_over_h_ * largest(solid.smoothing_length),
                      solid.smoothing_length);
    reorder(solid, solid_grid_.order());
    solid_grid_.particles_were_sorted(0);
    solid_index_of_id_.resize(solid.owned);
    for (std::size_t i = 0; i < solid.owned; ++i) solid_index_of_id_[solid.id[i]] = static_cast<Index>(i);
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
void Neighborhood<Dim>::sort_walls() {
    auto& wall = state_.wall;
    if (effects_.has(Effect::moving_wall)) wrap_walls();
    wall_grid_.build(wall.position, 0, wall.owned, cell_over_h_ * largest(wall.smoothing_length),
                     wall.smoothing_length);
    reorder(wall, wall_grid_.order());
    wall_grid_.particles_were_sorted(0);
    make_wall_images();
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
void Neighborhood<Dim>::build_fluid() {
    if (state_.fluid.owned == 0) return;
    wrap_fluid();
    sort_fluid();
    if (effects_.has(Effect::moving_wall)) sort_walls();
    if (has_images()) make_fluid_images();
    const std::array<const Grid*, 2> fluids{&fluid_grid_, &fluid_image_grid_};
    const std::array<const Grid*, 2> walls{&wall_grid_, &wall_image_grid_};
    const CutOff cut = pair_cut(fluid_skin_.skin());
    search_.build(fluid_grid_, fluids, cut, fluid_fluid);
    if (effects_.has(Effect::fixed_wall)) {
        search_.build(fluid_grid_, walls, cut, fluid_wall);
        search_.build(wall_grid_, fluids, cut, wall_fluid);
    }
    fluid_skin_.was_built();
    prune_fluid();
    ++builds_;
}

template <int Dim>
void Neighborhood<Dim>::prune_fluid() {
    const Set fluid{state_.fluid.position, state_.fluid.smoothing_length};
    const Set wall{state_.wall.position, state_.wall.smoothing_length};
    const CutOff cut = pair_cut(fluid_skin_.prune());
    search_.prune(fluid, fluid, cut, fluid_fluid);
    if (!effects_.has(Effect::fixed_wall)) return;
    search_.prune(fluid, wall, cut, fluid_wall);
    search_.prune(wall, fluid, cut, wall_fluid);
}

template <int Dim>
void Neighborhood<Dim>::build_solid() {
    if (state_.solid.owned == 0) return;
    sort_solid();
    const std::array<const Grid*, 1> solids{&solid_grid_};
    // Neighbours in the reference configuration stay neighbours.
    const bool for_good = effects_.has(Effect::total_lagrangian);
    search_.build(solid_grid_, solids, pair_cut(for_good ? 0.0 : solid_skin_.skin()), solid_solid);
    solid_skin_.was_built();
    if (for_good) {
        const Set solid{state_.solid.position, state_.solid.smoothing_length};
        search_.prune(solid, solid, pair_cut(0), solid_solid);
    } else
        prune_solid();
}

template <int Dim>
void Neighborhood<Dim>::prune_solid() {
    const typename NeighborSearch<Dim>::Set solid{state_.solid.position, state_.solid.smoothing_length};
    search_.prune(solid, solid, pair_cut(solid_skin_.prune()), solid_solid);
}

template <int Dim>
void Neighborhood<Dim>::build_coupling() {
    if (effects_.has(Effect::interface_force)) build_interface();
    if (effects_.has(Effect::moving_boundary)) build_boundary();
    coupling_skin_.was_built();
}

template <int Dim>
void Neighborhood<Dim>::list_coupling(const Grid& query, const Set& a, const Grid& target, const Set& b,
                                      const CutOff& cut, NeighborList& list) {
    const std::array<const Grid*, 1> targets{&target};
    CutOff wide = cut;
    wide.skin += fluid_skin_.motion() + solid_skin_.motion();  // the particles' grids are as old as their lists
    search_.build(query, targets, wide, list);
    search_.prune(a, b, cut, list);
}

template <int Dim>
void Neighborhood<Dim>::build_interface() {
    auto& elements = state_.elements;
    // A total-Lagrangian solid keeps its order and its lists; this grid must follow it all the same.
    if (effects_.has(Effect::total_lagrangian))
        solid_grid_.build(state_.solid.position, 0, state_.solid.owned,
                          cell_over_h_ * largest(state_.solid.smoothing_length), state_.solid.smoothing_length);
    state_.surface.update(state_.solid.position, solid_index_of_id_, elements);
    element_grid_.build(elements.position, 0, elements.owned, cell_over_h_ * state_.max_h);
    const bool mirrored = has_images();
    if (mirrored) make_element_images();
    const Set fluid{state_.fluid.position, state_.fluid.smoothing_length};
    const Set solid{state_.solid.position, state_.solid.smoothing_length};
    const Set faces{elements.position, elements.smoothing_length};
    // Between an element and a particle: the particle's support.
    const CutOff of_target{coupling_skin_.skin(), 0, support_}, of_query{coupling_skin_.skin(), support_, 0};
    list_coupling(element_grid_, faces, fluid_grid_, fluid, of_target, element_fluid);
    list_coupling(fluid_grid_, fluid, element_grid_, faces, of_query, fluid_element);
    list_coupling(element_grid_, faces, solid_grid_, solid, of_target, element_solid);
    list_coupling(solid_grid_, solid, element_grid_, faces, of_query, solid_element);
    if (!mirrored) return;
    list_coupling(element_grid_, faces, fluid_image_grid_, fluid, of_target, element_image);
    list_coupling(fluid_grid_, fluid, element_image_grid_, faces, of_query, image_element);
}

template <int Dim>
void Neighborhood<Dim>::build_boundary() {
    auto& boundary = state_.boundary;
    for (std::size_t i = 0; i < boundary.owned; ++i)
        boundary.position.set(i, state_.solid.position[solid_index_of_id_[boundary.solid[i]]]);
    boundary_grid_.build(boundary.position, 0, boundary.owned, cell_over_h_ * state_.max_h, boundary.smoothing_length);
    const bool mirrored = has_images();
    if (mirrored) make_boundary_images();
    const Set fluid{state_.fluid.position, state_.fluid.smoothing_length};
    const Set solid{boundary.position, boundary.smoothing_length};
    const CutOff cut = pair_cut(coupling_skin_.skin());
    list_coupling(boundary_grid_, solid, fluid_grid_, fluid, cut, boundary_fluid);
    list_coupling(fluid_grid_, fluid, boundary_grid_, solid, cut, fluid_boundary);
    if (!mirrored) return;
    list_coupling(boundary_grid_, solid, fluid_image_grid_, fluid, cut, boundary_image);
    list_coupling(fluid_grid_, fluid, boundary_image_grid_, solid, cut, image_boundary);
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
    wall.ghost_velocity.resize(wall.position.size());
    wall_images_.refresh_directions(wall.ghost_velocity, wall.owned);
    resize_tight(wall.friction_volume, wall.position.size());
    wall_images_.refresh(wall.friction_volume, wall.owned);
}

template <int Dim>
void Neighborhood<Dim>::refresh_boundary_friction() {
    auto& boundary = state_.boundary;
    boundary.ghost_velocity.resize(boundary.position.size());
    boundary_images_.refresh_directions(boundary.ghost_velocity, boundary.owned);
}

template <int Dim>
std::size_t Neighborhood<Dim>::bytes() const {
    std::size_t sum = 0;
    for (const NeighborList* list : {&fluid_fluid, &fluid_wall, &wall_fluid, &solid_solid, &element_fluid,
                                     &fluid_element, &element_solid, &solid_element, &element_image, &image_element,
                                     &fluid_boundary, &boundary_fluid, &boundary_image, &image_boundary})
        sum += list->bytes();
    for (const Grid* grid : {&fluid_grid_, &fluid_image_grid_, &wall_grid_, &wall_image_grid_, &solid_grid_,
                             &element_grid_, &element_image_grid_, &boundary_grid_, &boundary_image_grid_})
        sum += grid->bytes();
    return sum + fluid_images_.bytes() + wall_images_.bytes() + element_images_.bytes() + boundary_images_.bytes();
}

template class Neighborhood<2>;
template class Neighborhood<3>;

}  // namespace sluice
