#include "engine/step/neighborhood.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

template <int Dim>
void Neighborhood<Dim>::sort_fluid() {
    auto& fluid = state_.fluid;
    fluid_grid_.build(fluid.position, 0, fluid.owned, cell_over_h_ * largest(fluid.smoothing_length),
                      fluid.smoothing_length);
    fluid.reorder(fluid_grid_.order());
    fluid_grid_.particles_were_sorted(0);
}

template <int Dim>
void Neighborhood<Dim>::sort_solid() {
    auto& solid = state_.solid;
    solid_grid_.build(solid.position, 0, solid.owned, cell_over_h_ * largest(solid.smoothing_length),
                      solid.smoothing_length);
    solid.reorder(solid_grid_.order());
    solid_grid_.particles_were_sorted(0);
    ++solid_layout_;
    solid_index_of_id_.resize(solid.owned);
    for (std::size_t i = 0; i < solid.owned; ++i) solid_index_of_id_[solid.id[i]] = static_cast<Index>(i);
}

template <int Dim>
void Neighborhood<Dim>::sort_walls() {
    auto& wall = state_.wall;
    if (effects_.has(Effect::moving_wall)) wrap_walls();
    wall_grid_.build(wall.position, 0, wall.owned, cell_over_h_ * largest(wall.smoothing_length),
                     wall.smoothing_length);
    wall.reorder(wall_grid_.order());
    wall_grid_.particles_were_sorted(0);
    ++wall_layout_;
    make_wall_images();
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
    if (effects_.has(Effect::clamp) && !for_good) {
        leave_out_resting({}, {});
        for (auto& column : state_.solid.velocity_gradient.c) std::fill(column.begin(), column.end(), 0.0);
    }
    if (for_good) {
        const Set solid{state_.solid.position, state_.solid.smoothing_length};
        search_.prune(solid, solid, pair_cut(0), solid_solid);
    } else
        prune_solid();
}

template <int Dim>
void Neighborhood<Dim>::prune_solid() {
    const Set solid{state_.solid.position, state_.solid.smoothing_length};
    const CutOff cut = pair_cut(solid_skin_.prune());
    search_.prune(solid, solid, cut, solid_solid);
    if (effects_.has(Effect::clamp)) search_.prune(solid, solid, cut, moving_solid_);
}

/// Clamped particles never move, so that stress changes only next to those that do: all others leave solid_solid.
template <int Dim>
void Neighborhood<Dim>::leave_out_resting(std::span<const std::uint8_t> rigid, std::span<const std::uint8_t> extended) {
    const auto& solid = state_.solid;
    Array<std::uint8_t> moving(solid.owned), stressed(solid.owned);
    for (std::size_t i = 0; i < solid.owned; ++i) moving[i] = !solid.clamped[i];
    solid_solid.mark_candidates(moving, stressed);
    for (std::size_t i = 0; i < rigid.size(); ++i) {
        if (rigid[i]) stressed[i] = 0;
        if (extended[i]) moving[i] = 1;
    }
    moving_solid_ = solid_solid;
    moving_solid_.keep_queries(moving);
    solid_solid.keep_queries(stressed);
}

template <int Dim>
void Neighborhood<Dim>::leave_out_clamped(std::span<const std::uint8_t> rigid, std::span<const std::uint8_t> extended) {
    if (!effects_.has(Effect::clamp)) return;
    leave_out_resting(rigid, extended);
    const Set solid{state_.solid.position, state_.solid.smoothing_length};  // the reference configuration still
    search_.prune(solid, solid, pair_cut(0), solid_solid);
    search_.prune(solid, solid, pair_cut(0), moving_solid_);
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
        boundary.position.set(i, state_.solid.position[solid_index_of_id_[boundary.solid_id[i]]]);
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
std::size_t Neighborhood<Dim>::bytes() const {
    std::size_t sum = moving_solid_.bytes();
    for (const NeighborList* list : {&fluid_fluid, &fluid_wall, &wall_fluid, &solid_solid, &element_fluid,
                                     &fluid_element, &element_solid, &solid_element, &element_image, &image_element,
                                     &fluid_boundary, &boundary_fluid, &boundary_image, &image_boundary})
        sum += list->bytes();
    for (const Grid* grid : {&fluid_grid_, &fluid_image_grid_, &wall_grid_, &wall_image_grid_, &solid_grid_,
                             &element_grid_, &element_image_grid_, &boundary_grid_, &boundary_image_grid_})
        sum += grid->bytes();
    for (const SetId set : all_sets) sum += state_[set].ghosts.bytes();
    return sum;
}

template class Neighborhood<2>;
template class Neighborhood<3>;

}  // namespace sluice
