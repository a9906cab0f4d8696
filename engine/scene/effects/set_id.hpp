// The sets of particles, by name: what effects, pairings and columns refer to.
#pragma once

#include <array>
#include <string_view>

namespace sluice {

/// The sets that a simulation has; those that a scene lacks are empty.
enum class SetId {
    fluid,
    solid,
    wall,      ///< layers of particles of rigid walls, which may move; their pressure is taken from the fluid
    elements,  ///< of the interface between fluid and solids: a closed surface around each solid body (surface.hpp)
    boundary   ///< the solids' particles that fluid can come near, as its moving boundary: copies of what it sees
};
inline constexpr std::array all_sets{SetId::fluid, SetId::solid, SetId::wall, SetId::elements, SetId::boundary};

constexpr std::string_view name_of(SetId set) {
    switch (set) {
        case SetId::fluid:
            return "fluid";
        case SetId::solid:
            return "solid";
        case SetId::wall:
            return "wall";
        case SetId::elements:
            return "elements";
        case SetId::boundary:
            return "boundary";
    }
    return {};
}

}  // namespace sluice
