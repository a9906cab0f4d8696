// Finds the solid particles that may touch another body or a wall: copies of them, and lists of what they may touch.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/particles/state.hpp"
#include "engine/step/neighborhood.hpp"
#include "neighbor/box.hpp"

namespace sluice {

/// Copies of solid particles near something that they may touch: what the passes read, and their results.
template <int Dim>
struct ContactParticles {
    Array<Index> solid;         ///< index in the solid set when they were copied
    Array<std::uint16_t> body;  ///< index into Scene::bodies
    VectorField<Dim> position;  ///< [m]
    ScalarField volume;         ///< V in the reference configuration [m³; m² in 2D]
    ScalarField smoothing_length;
    ScalarField density;             ///< σ of kernels/passes/contact_passes.hpp
    ScalarField pressure;            ///< p [Pa]
    VectorField<Dim> force_density;  ///< f/V [N/m³]; before it is known ∇σ [1/m]

    std::size_t size() const { return solid.size(); }
    void clear();
    void add(const ParticleSet<Dim>& phase, std::size_t i, double reference_volume);
    /// Sizes the results, at zero.
    void finish();
    std::size_t bytes() const;

    /// visit(name, member) for each member.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("solid", solid), visit("body", body), visit("position", position.c), visit("volume", volume);
        visit("smoothing_length", smoothing_length), visit("density", density), visit("pressure", pressure);
        visit("force_density", force_density.c);
    }
};

/// All pairs of groups that press on each other with the same stiffness: that of the softer of the two.
template <int Dim>
struct BodyContact {
    double modulus = 0;               ///< λ + 2μ of the softer one [Pa]
    ContactParticles<Dim> particles;  ///< of all groups that have such a partner nearby
    std::vector<NeighborList> lists;  ///< of each group with its partners, all within `particles`

    /// visit(name, member) for what outlives a search.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("particles", particles), visit("lists", lists);
    }
};

/// Tracks how far anything has moved, and searches again when something may have come near. Where nothing is near,
/// there are no copies and no lists, and the next search is due when the nearest two may have met.
///
/// Bodies are near if their boxes are; a particle is copied if it is near the other's box. Walls likewise. There is no
/// contact within a group of joined bodies, of a body with itself, or across the sides of a periodic box.
template <int Dim>
class ContactSearch {
  public:
    ContactSearch(State<Dim>& state, const Neighborhood<Dim>& neighbors, double support);

    /// Reports that nothing has moved farther than this since the last call. [m]
    void add_motion(double distance) { moved_ += distance; }
    /// Makes copies and lists for the current positions, if the old ones are outdated.
    void update();
    std::uint64_t builds() const { return builds_; }
    std::size_t bytes() const;

    /// visit(name, member) for what outlives a search.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("bodies", bodies), visit("at_walls", at_walls);
        visit("wall_list", wall_list), visit("at_planes", at_planes), visit("members", members_);
        visit("moved", moved_), visit("room", room_), visit("builds", builds_);
        visit("solid_layout", solid_layout_), visit("wall_layout", wall_layout_);
    }

    std::vector<BodyContact<Dim>> bodies;  ///< one, if all solids are of one material
    ContactParticles<Dim> at_walls;
    NeighborList wall_list;               ///< wall particles near at_walls, ghosts included
    std::vector<Array<Index>> at_planes;  ///< solid particles near each mirror plane

  private:
    using Grid = ClusterGrid<Dim>;
    using Set = typename NeighborSearch<Dim>::Set;

    bool outdated() const;
    void build();
    /// Finds the stiffnesses with which groups may meet.
    void find_moduli();
    double modulus_between(std::size_t a, std::size_t b) const { return std::min(modulus_[a], modulus_[b]); }
    void list_bodies();
    void list_contact(const std::vector<Box<Dim>>& box, const std::vector<std::vector<std::size_t>>& near,
                      BodyContact<Dim>& contact);
    void list_walls();
    void list_planes();
    void sort_into_groups();
    /// Copies the group's particles that are near one of these boxes. Returns whether there are any.
    bool select(const Array<Index>& members, const std::vector<Box<Dim>>& boxes, ContactParticles<Dim>& to);
    /// Notes that something is this far out of reach. Returns whether it is near.
    bool is_near(double gap);
    double volume_of(std::size_t i) const {
        return state_.solid.mass[i] / state_.solid_materials.of_body(state_.solid.body[i]).eos.density;
    }

    State<Dim>& state_;
    const Neighborhood<Dim>& neighbors_;
    double support_;
    double reach_ = 0, skin_ = 0, cell_ = 0;  ///< [m]
    double moved_ = 0, room_ = 0;             ///< motion since the last search, and until the next one is due [m]
    std::uint64_t builds_ = 0, solid_layout_ = 0, wall_layout_ = 0;
    std::vector<Array<Index>> members_;  ///< of each group
    std::vector<double> modulus_;        ///< λ + 2μ of each group's softest material [Pa]
    std::vector<Grid> grids_;            ///< of each group's copies
    Grid at_wall_grid_, wall_grid_;
    NeighborSearch<Dim> search_;
};

extern template class ContactSearch<2>;
extern template class ContactSearch<3>;

}  // namespace sluice
