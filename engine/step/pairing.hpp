// A pairing: two sets of particles, and the list of the neighbours that one has in the other.
#pragma once

#include <functional>
#include <string>

#include "engine/particles/part_range.hpp"
#include "engine/particles/particle_set.hpp"
#include "neighbor/neighbor_list.hpp"

namespace sluice {

/// Which particles of the target set are searched.
enum class Targets { own, ghosts, all };

/// Which smoothing length sets the cut-off of a pair: the mean of both, or one side's where the other has none.
enum class Reach { mean, of_query, of_target };

/// When a list is rebuilt.
enum class Upkeep {
    with_fluid,  ///< with all lists of the fluid, once it has moved as far as their skin allows
    with_solid,  ///< with all lists of the hypoelastic solid, likewise
    coupling,    ///< when one of these is rebuilt, or fluid and solids together have moved too far
    for_good     ///< never: neighbours in the reference configuration stay neighbours
};

/// What identifies a pairing.
struct PairingKey {
    SetId query, target;
    Upkeep upkeep = Upkeep::with_fluid;
    Targets targets = Targets::all;
    Reach reach = Reach::mean;
    PartRange range{};  ///< for pairs within a part: its range of the set; empty = all

    friend bool operator==(const PairingKey& a, const PairingKey& b) {
        return a.query == b.query && a.target == b.target && a.upkeep == b.upkeep && a.targets == b.targets &&
               a.reach == b.reach && a.range.first == b.range.first && a.range.last == b.range.last;
    }
};

struct Pairing {
    PairingKey key;
    std::string name;  ///< in checkpoints
    /// Called after a search, before the list is first pruned; may be empty.
    std::function<void()> searched = {};
    /// Made from the list of another pairing, by that one's `searched`; only pruned, never searched, by itself.
    bool derived = false;
    NeighborList list = {};
};

}  // namespace sluice
