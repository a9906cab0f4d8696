// Who meets whom: keeps particles in Morton order, makes images at mirror walls, and holds the neighbour lists.
#pragma once

#include <vector>

#include "engine/state/state.hpp"
#include "neighbor/cell_grid.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice {

template <int Dim>
class Neighborhood {
  public:
    Neighborhood(State<Dim>& state, const Effects& effects);

    /// Tells that no particle has moved farther than this since the last call. [m]
    void add_motion(double distance) { moved_ += distance; }
    /// True if some pair may have come within its support without being listed.
    bool outdated() const { return 2 * moved_ > skin_; }
    /// Re-sorts the particles and builds images and lists anew.
    void rebuild();

    /// Images follow their owners.
    void refresh_fluid_positions();
    void refresh_fluid_velocities();
    void refresh_fluid_scalars();
    void refresh_elements();
    void refresh_wall_pressure();
    /// A fluid particle that slipped through a mirror plane changes places with its image, which is the same state.
    void reflect_strays();

    const std::vector<Index>& solid_index_of_id() const { return solid_index_of_id_; }
    std::uint64_t builds() const { return builds_; }
    std::size_t bytes() const;

    // a_b: for each particle of a, its neighbours among b
    NeighborList fluid_fluid, fluid_wall, wall_fluid, solid_solid;
    NeighborList element_fluid, fluid_element, element_solid, solid_element;

  private:
    void sort_particles();
    void drop_images();
    void make_images();
    void build_grids();
    void build_lists();

    State<Dim>& state_;
    const Effects& effects_;
    double skin_;
    double moved_ = 0;
    std::uint64_t builds_ = 0;
    std::vector<Index> solid_index_of_id_;
    Images<Dim> fluid_images_, wall_images_, element_images_;
    CellGrid<Dim> fluid_grid_, solid_grid_, wall_grid_, element_grid_;
    NeighborSearch<Dim> search_;
};

extern template class Neighborhood<2>;
extern template class Neighborhood<3>;

}  // namespace sluice
