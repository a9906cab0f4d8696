// Who meets whom: keeps particles in the order of their clusters, makes images at mirror walls, and holds the neighbour
// lists.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/particles/state.hpp"
#include "engine/step/skin.hpp"
#include "neighbor/cluster_grid.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice {

template <int Dim>
class Neighborhood {
  public:
    /// h_over_d: smoothing length over spacing, for the size of the cells. support: of the smoothing function, in h.
    Neighborhood(State<Dim>& state, const Effects& effects, double h_over_d, double support);

    /// Tells how far particles will about move in the first step, and a solid's in its first sub-step. [m]
    void expect_motion(double of_fluid, double of_solid, double of_solid_substep);
    /// Tells that no solid particle has moved farther than this in a sub-step. [m]
    void add_solid_motion(double distance) { solid_skin_.add_motion(distance); }
    /// Tells that in a whole step no particle has moved farther than this. [m]
    void add_motion(double of_fluid, double of_solid);

    /// Brings lists up to date for the step to come: builds, or prunes, those that need it. Particles may change their
    /// places in memory.
    void update();
    /// The same for what a solid's sub-step needs.
    void update_solid();

    /// Tells that the stress of a total-Lagrangian solid's start is known: where it stays for good it needs no passes.
    /// The stress of `rigid` particles is not asked for, but forces on the `extended` ones are (clamp_extension.hpp).
    void leave_out_clamped(std::span<const std::uint8_t> rigid, std::span<const std::uint8_t> extended);
    /// The rows of solid_solid whose forces are asked for: not of those that are clamped, but for those `extended`.
    const NeighborList& moving_solid() const { return effects_.has(Effect::clamp) ? moving_solid_ : solid_solid; }

    const std::vector<Index>& solid_index_of_id() const { return solid_index_of_id_; }
    /// These change when particles have changed their places in memory.
    std::uint64_t solid_layout() const { return solid_layout_; }
    std::uint64_t wall_layout() const { return wall_layout_; }
    std::uint64_t builds() const { return builds_; }
    std::size_t bytes() const;

    /// visit(name, member) for lists, grids, images and how old they are. With all of it a run goes on to the same
    /// bits: lists built anew elsewhere would add up pairs in another order.
    template <class Visit>
    void visit_state(Visit&& visit);

    // a_b: for each particle of a, its neighbours among b
    NeighborList fluid_fluid, fluid_wall, wall_fluid;
    NeighborList solid_solid;  ///< without those whose stress never changes
    NeighborList element_solid, solid_element, element_fluid, fluid_element;
    NeighborList element_image;  ///< elements and the images of fluid particles
    NeighborList image_element;  ///< fluid particles and the images of elements
    NeighborList fluid_boundary, boundary_fluid;
    NeighborList boundary_image;  ///< boundary particles and the images of fluid particles
    NeighborList image_boundary;  ///< fluid particles and the images of boundary particles

  private:
    using Grid = ClusterGrid<Dim>;
    using Set = typename NeighborSearch<Dim>::Set;

    /// Pairs meet within the support of their mean smoothing length.
    double half_support() const { return 0.5 * support_; }
    CutOff pair_cut(double skin) const { return {skin, half_support(), half_support()}; }
    bool refresh_solid();
    void build_fluid();
    void build_solid();
    void build_coupling();
    void leave_out_resting(std::span<const std::uint8_t> rigid, std::span<const std::uint8_t> extended);
    void prune_fluid();
    void prune_solid();
    bool has_images() const { return !state_.ghost_planes.empty(); }
    void wrap_fluid();
    void sort_fluid();
    void sort_solid();
    void wrap_walls();
    void sort_walls();
    template <class Range>
    void make_ghosts(ParticleSet<Dim>& set, Grid& grid, double cell, bool with_reach, Range&& range);
    void make_fluid_images();
    void make_wall_images();
    void make_element_images();
    void make_boundary_images();
    void build_interface();
    void build_boundary();
    void list_coupling(const Grid& query, const Set& a, const Grid& target, const Set& b, const CutOff& cut,
                       NeighborList& list);

    State<Dim>& state_;
    const Effects& effects_;
    double cell_over_h_;
    double support_;
    SkinAccount fluid_skin_, solid_skin_, coupling_skin_;
    std::uint64_t builds_ = 0, solid_layout_ = 0, wall_layout_ = 0;
    std::vector<Index> solid_index_of_id_;
    Grid fluid_grid_, fluid_image_grid_, wall_grid_, wall_image_grid_, solid_grid_, element_grid_, element_image_grid_,
        boundary_grid_, boundary_image_grid_;
    NeighborList moving_solid_;
    NeighborSearch<Dim> search_;
};

template <int Dim>
template <class Visit>
void Neighborhood<Dim>::visit_state(Visit&& visit) {
    visit("fluid_skin", fluid_skin_), visit("solid_skin", solid_skin_), visit("coupling_skin", coupling_skin_);
    visit("builds", builds_), visit("solid_layout", solid_layout_), visit("wall_layout", wall_layout_);
    visit("solid_index_of_id", solid_index_of_id_);
    for (const SetId set : all_sets) visit(std::string(name_of(set)) + "_ghosts", state_[set].ghosts);
    visit("fluid_grid", fluid_grid_), visit("fluid_image_grid", fluid_image_grid_);
    visit("wall_grid", wall_grid_), visit("wall_image_grid", wall_image_grid_), visit("solid_grid", solid_grid_);
    visit("element_grid", element_grid_), visit("element_image_grid", element_image_grid_);
    visit("boundary_grid", boundary_grid_), visit("boundary_image_grid", boundary_image_grid_);
    visit("fluid_fluid", fluid_fluid), visit("fluid_wall", fluid_wall), visit("wall_fluid", wall_fluid);
    visit("solid_solid", solid_solid), visit("moving_solid", moving_solid_);
    visit("element_solid", element_solid), visit("solid_element", solid_element);
    visit("element_fluid", element_fluid), visit("fluid_element", fluid_element);
    visit("element_image", element_image), visit("image_element", image_element);
    visit("fluid_boundary", fluid_boundary), visit("boundary_fluid", boundary_fluid);
    visit("boundary_image", boundary_image), visit("image_boundary", image_boundary);
}

extern template class Neighborhood<2>;
extern template class Neighborhood<3>;

}  // namespace sluice
