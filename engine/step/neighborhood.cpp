#include "engine/step/neighborhood.hpp"

#include <algorithm>
#include <tuple>

#include "engine/state/reorder.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// Skin over the smallest smoothing length. A thicker skin means fewer builds but more pairs outside the support in
/// every pass; the optimum is flat.
constexpr double skin_over_h = 0.25;

/// Builds between two sorts: order in memory decays slowly, by a spacing or so in this many builds.
constexpr std::uint64_t builds_per_sort = 8;

double smallest(const ScalarField& h, double otherwise) {
    return h.empty() ? otherwise : *std::min_element(h.begin(), h.end());
}

}  // namespace

template <int Dim>
Neighborhood<Dim>::Neighborhood(State<Dim>& state, const Effects& effects)
    : state_(state), effects_(effects), skin_(skin_over_h * state.min_h) {
    rebuild();
}

template <int Dim>
void Neighborhood<Dim>::rebuild() {
    if (builds_ % builds_per_sort == 0)
        sort_particles();
    else
        drop_images();
    if constexpr (Dim == 2)
        if (!state_.surface.empty()) state_.surface.update(state_.solid, solid_index_of_id_, state_.elements);
    make_images();
    build_grids();
    build_lists();
    moved_ = 0;
    ++builds_;
}

template <int Dim>
void Neighborhood<Dim>::sort_particles() {
    // Finer than the search cells, so that the members of a group, which follow each other, lie close together.
    if (state_.fluid.owned > 0) {
        const double cell = 0.5 * smallest(state_.fluid.smoothing_length, 1);
        fluid_grid_.build(state_.fluid.position, state_.fluid.owned, cell);
        reorder(state_.fluid, fluid_grid_.order());
    }
    if (state_.solid.owned > 0) {
        const double cell = 0.5 * smallest(state_.solid.smoothing_length, 1);
        solid_grid_.build(state_.solid.position, state_.solid.owned, cell);
        reorder(state_.solid, solid_grid_.order());
    }
    solid_index_of_id_.resize(state_.solid.owned);
    for (std::size_t i = 0; i < state_.solid.owned; ++i) solid_index_of_id_[state_.solid.id[i]] = static_cast<Index>(i);
}

template <int Dim>
void Neighborhood<Dim>::drop_images() {
    auto& fluid = state_.fluid;
    fluid.position.resize(fluid.owned);
    fluid.velocity.resize(fluid.owned);
    for (ScalarField* column :
         {&fluid.density, &fluid.mass, &fluid.smoothing_length, &fluid.pressure, &fluid.pressure_over_rho2})
        column->resize(fluid.owned);
}

template <int Dim>
void Neighborhood<Dim>::make_images() {
    if (!effects_.has(Effect::mirror_wall)) return;
    const auto& mirrors = state_.mirrors;
    // A particle at distance s from the plane has its image at −s; the nearest that can feel it stands on the plane.
    auto& fluid = state_.fluid;
    const double farthest = state_.max_h + skin_;
    fluid_images_.create(mirrors, fluid.position, fluid.owned,
                         [&](std::size_t i) { return fluid.smoothing_length[i] + farthest; });
    for (ScalarField* column :
         {&fluid.density, &fluid.mass, &fluid.smoothing_length, &fluid.pressure, &fluid.pressure_over_rho2})
        fluid_images_.extend(*column, fluid.owned);
    fluid.velocity.resize(fluid.owned + fluid_images_.count());
    refresh_fluid_velocities();

    auto& wall = state_.wall;
    wall_images_.create(mirrors, wall.position, wall.owned,
                        [&](std::size_t i) { return wall.smoothing_length[i] + farthest; });
    for (ScalarField* column : {&wall.volume, &wall.smoothing_length, &wall.pressure})
        wall_images_.extend(*column, wall.owned);

    auto& elements = state_.elements;
    element_images_.create(mirrors, elements.position, elements.owned,
                           [&](std::size_t) { return state_.max_h + farthest; });
    elements.area_normal.resize(elements.owned + element_images_.count());
    elements.velocity.resize(elements.owned + element_images_.count());
    refresh_elements();
}

template <int Dim>
void Neighborhood<Dim>::build_grids() {
    const double cell = 2 * state_.min_h + skin_;
    const auto& fluid = state_.fluid;
    const auto& solid = state_.solid;
    const auto& wall = state_.wall;
    fluid_grid_.build(fluid.position, fluid.position.size(), cell, fluid.smoothing_length);
    solid_grid_.build(solid.position, solid.owned, cell, solid.smoothing_length);
    if (effects_.has(Effect::fixed_wall))
        wall_grid_.build(wall.position, wall.position.size(), cell, wall.smoothing_length);
    if (effects_.has(Effect::interface_force))
        element_grid_.build(state_.elements.position, state_.elements.position.size(), cell);
}

template <int Dim>
void Neighborhood<Dim>::build_lists() {
    using Set = typename NeighborSearch<Dim>::Set;
    const auto& [fluid, solid, wall, elements] = std::tie(state_.fluid, state_.solid, state_.wall, state_.elements);
    const Set fluids{fluid.position, fluid_grid_}, solids{solid.position, solid_grid_};
    const Set walls{wall.position, wall_grid_}, faces{elements.position, element_grid_};
    const auto& h_f = fluid.smoothing_length;
    const auto& h_s = solid.smoothing_length;
    const auto& h_w = wall.smoothing_length;
    // Support 2h with the pair's mean h: the reaches h_i + h_j. Between an element and a particle: the particle's 2h.
    search_.build(fluids, fluid.owned, fluids, {h_f, h_f, skin_}, max_group_size, fluid_fluid);
    search_.build(solids, solid.owned, solids, {h_s, h_s, skin_}, max_group_size, solid_solid);
    if (effects_.has(Effect::fixed_wall)) {
        search_.build(fluids, fluid.owned, walls, {h_f, h_w, skin_}, max_group_size, fluid_wall);
        search_.build(walls, wall.owned, fluids, {h_w, h_f, skin_}, max_group_size, wall_fluid);
    }
    if (effects_.has(Effect::interface_force)) {
        search_.build(faces, elements.owned, fluids, {{}, h_f, skin_, 1, 2}, 1, element_fluid);
        search_.build(fluids, fluid.owned, faces, {h_f, {}, skin_, 2, 1}, 1, fluid_element);
        search_.build(faces, elements.owned, solids, {{}, h_s, skin_, 1, 2}, 1, element_solid);
        search_.build(solids, solid.owned, faces, {h_s, {}, skin_, 2, 1}, 1, solid_element);
    }
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
void Neighborhood<Dim>::reflect_strays() {
    if (!effects_.has(Effect::mirror_wall)) return;
    auto& fluid = state_.fluid;
    for (const MirrorPlane<Dim>& plane : state_.mirrors)
        parallel_for(fluid.owned, [&](std::size_t i) {
            if (plane.distance(fluid.position[i]) >= 0) return;
            fluid.position.set(i, plane.reflect_position(fluid.position[i]));
            fluid.velocity.set(i, plane.reflect_direction(fluid.velocity[i]));
        });
}

template <int Dim>
std::size_t Neighborhood<Dim>::bytes() const {
    std::size_t sum = 0;
    for (const NeighborList* list : {&fluid_fluid, &fluid_wall, &wall_fluid, &solid_solid, &element_fluid,
                                     &fluid_element, &element_solid, &solid_element})
        sum += list->bytes();
    return sum + fluid_images_.bytes() + wall_images_.bytes() + element_images_.bytes();
}

template class Neighborhood<2>;
template class Neighborhood<3>;

}  // namespace sluice
