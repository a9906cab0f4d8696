// Sorts particles into clusters, makes ghosts, and keeps the neighbour lists of all pairings.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "engine/particles/id_index.hpp"
#include "engine/particles/state.hpp"
#include "engine/step/pairing.hpp"
#include "engine/step/skin.hpp"
#include "neighbor/cluster_grid.hpp"

namespace sluice {

/// Parts and couplings ask for the pairings that they need; then all lists are built, and kept up to date from step to
/// step.
template <int Dim>
class Neighborhood {
  public:
    /// h_over_d: smoothing length over spacing, which sets the size of the cells. support: of the smoothing function,
    /// in h.
    Neighborhood(State<Dim>& state, const Effects& effects, double h_over_d, double support);

    /// Returns the pairing with this key, the same for all callers. Call before build().
    Pairing& pair(const PairingKey& key);
    /// Adds a pairing whose list is made from that of another (Pairing::derived), with a name of its own.
    Pairing& derive(const Pairing& from, const std::string& name);
    /// Has place() called before the lists of a coupling's set are built: it puts the particles of the set, copies or
    /// elements, in place.
    void place_before(SetId set, std::function<void()> place) { placing_.push_back({set, std::move(place)}); }

    /// Sorts particles and makes ghosts and lists for the first time.
    void build();

    /// Estimates how far particles will move in the first step, and those of a solid in its first sub-step. [m]
    void expect_motion(double of_fluid, double of_solid, double of_solid_substep);
    /// Reports that no particle of the hypoelastic solid has moved farther than this in a sub-step. [m]
    void add_solid_motion(double distance) { solid_skin_.add_motion(distance); }
    /// Reports that no particle has moved farther than this in a whole step. [m]
    void add_motion(double of_fluid, double of_solid);

    /// Builds or prunes the lists that need it for the next step. Particles may change their places in memory.
    void update();
    /// The same for the lists of a hypoelastic solid, between its sub-steps.
    void update_solid();
    /// Prunes a list for good, to the pairs within the support now.
    void prune_for_good(Pairing& pairing);

    const IdIndex& solid_index_of_id() const { return solid_index_of_id_; }
    // Numbers that change when particles have changed their places in memory.
    std::uint64_t solid_layout() const { return solid_layout_; }
    std::uint64_t wall_layout() const { return wall_layout_; }
    std::uint64_t builds() const { return builds_; }
    std::size_t bytes() const;

    /// visit(name, member) for lists, grids, ghosts and their ages. With all of these a resumed run has the same bits;
    /// lists built anew at another time would add up pairs in another order.
    template <class Visit>
    void visit_state(Visit&& visit);

  private:
    using Grid = ClusterGrid<Dim>;
    using Set = typename NeighborSearch<Dim>::Set;

    /// The grids of a set's particles, or of a part's range of them, and of its ghosts.
    struct Grids {
        SetId set;
        PartRange range;  ///< empty = all
        Grid own{}, ghosts{};
    };
    struct Placing {
        SetId set;
        std::function<void()> place;
    };

    /// Pairs meet within the support of their mean smoothing length.
    double half_support() const { return 0.5 * support_; }
    CutOff cut_off(Reach reach, double skin) const;
    bool has_ghosts() const { return !state_.ghost_planes.empty(); }
    PartRange within(SetId set, const PartRange& range) const;
    Grids& grids_of(SetId set, const PartRange& range = {});
    Set places_of(SetId set) const { return {state_[set].position, state_[set].smoothing_length}; }

    bool refresh_solid();
    void build_fluid();
    void build_solid();
    void build_for_good();
    void build_coupling();
    void search(Upkeep upkeep);
    void prune(Upkeep upkeep, double skin);
    void search_coupling(Pairing& pairing);

    /// Sorts a set's particles, or a range of them, into the order of their grid.
    void sort(SetId set, const PartRange& range = {});
    void sort_walls();
    void number_solids();
    /// Brings particles that have left a periodic box back in at the other side.
    void wrap_fluid();
    void wrap_walls();
    void make_ghosts(SetId set, double skin);
    void grid_copies(SetId set);
    double cell_of(SetId set) const;

    State<Dim>& state_;
    const Effects& effects_;
    double cell_over_h_;
    double support_;
    SkinAccount fluid_skin_, solid_skin_, coupling_skin_;
    std::uint64_t builds_ = 0, solid_layout_ = 0, wall_layout_ = 0;
    IdIndex solid_index_of_id_;
    std::deque<Pairing> pairings_;
    std::deque<Grids> grids_;
    std::vector<Placing> placing_;
    NeighborSearch<Dim> search_;
};

template <int Dim>
template <class Visit>
void Neighborhood<Dim>::visit_state(Visit&& visit) {
    visit("fluid_skin", fluid_skin_), visit("solid_skin", solid_skin_), visit("coupling_skin", coupling_skin_);
    visit("builds", builds_), visit("solid_layout", solid_layout_), visit("wall_layout", wall_layout_);
    visit("solid_index_of_id", solid_index_of_id_);
    for (const SetId set : all_sets) visit(std::string(name_of(set)) + "_ghosts", state_[set].ghosts);
    for (Grids& grids : grids_) {
        std::string name(name_of(grids.set));
        if (!grids.range.empty()) name += "_from_" + std::to_string(grids.range.first);
        visit(name + "_grid", grids.own), visit(name + "_ghost_grid", grids.ghosts);
    }
    for (Pairing& pairing : pairings_) visit(pairing.name, pairing.list);
}

extern template class Neighborhood<2>;
extern template class Neighborhood<3>;

}  // namespace sluice
