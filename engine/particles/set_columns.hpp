// The columns of a set of particles as part of a checkpoint (engine/files/state_visitors.hpp).
#pragma once

#include <string>

#include "engine/base/errors.hpp"
#include "engine/particles/particle_set.hpp"

namespace sluice {

/// Visits all columns of a set. When reading, the checkpoint must hold as many particles and the same columns as the
/// scene calls for.
template <int Dim>
struct SetColumns {
    ParticleSet<Dim>& set;

    template <class Visit>
    void visit_state(Visit&& visit) const {
        std::uint64_t owned = set.owned;
        visit("owned", owned);
        if (owned != set.owned) throw CheckpointError("the checkpoint does not fit: another number of particles");
        for_each_field(set, [&](auto tag, auto& field) {
            const std::string name(info_of(tag.column).name);
            int component = 0;
            for_each_component(field, [&](auto& column) {
                const bool expected = !column.empty();
                visit(component == 0 ? name : name + "_" + std::to_string(component), column);
                if (expected != !column.empty() || (expected && column.size() < owned))
                    throw CheckpointError("the checkpoint does not fit: another size of " + name);
                ++component;
            });
        });
    }
};

}  // namespace sluice
