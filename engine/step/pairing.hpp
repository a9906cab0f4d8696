// Who meets whom: two sets of particles and the list of their neighbours.
#pragma once

#include <functional>
#include <string>

#include "engine/particles/part_range.hpp"
#include "engine/particles/particle_set.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice {

/// Which of the targets' particles are looked at.
enum class Targets { own, ghosts, all };

/// Whose smoothing length says how far a pair reaches: the mean of both, or one side's where the other has none.
enum class Reach { mean, of_query, of_target };

/// When a list is built anew.
enum class Upkeep {
    with_fluid,  ///< together with all lists of the fluid, when it has moved as far as their skin allows
    with_solid,  ///< likewise of the hypoelastic solid
    coupling,    ///< when one of these is, or fluid and solids have together moved too far
    for_good     ///< never: neighbours in the reference configuration stay neighbours
};

/// What a pairing is known by.
struct PairingKey {
    SetId query, target;
    Upkeep upkeep = Upkeep::with_fluid;
    Targets targets = Targets::all;
    Reach reach = Reach::mean;
    PartRange range{};  ///< of the query's and target's particles, for a part among itself; empty = all

    friend bool operator==(const PairingKey& a, const PairingKey& b) {
        return a.query == b.query && a.target == b.target && a.upkeep == b.upkeep && a.targets == b.targets &&
               a.reach == b.reach && a.range.first == b.range.first && a.range.last == b.range.last;
    }
};

struct Pairing {
    PairingKey key;
    std::string name;  ///< in checkpoints
    /// Called when the list has been searched for, before it is pruned for the first time; may be empty.
    std::function<void()> searched = {};
    /// Taken from another pairing's list by its `searched`, and only pruned by itself.
    bool derived = false;
    NeighborList list = {};
};

}  // namespace sluice
