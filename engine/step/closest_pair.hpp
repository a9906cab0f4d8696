// The pair of particles that has come closest, if any has come too close.
#pragma once

#include "neighbor/neighbor_list.hpp"

namespace sluice {

/// What a fluid particle has come too close to.
enum class Neighbor { fluid, solid, wall };

/// What is too close, in spacings: among the fluid, and to walls and solids.
struct Nearness {
    double fluid = 0, boundary = 0;
};

struct ClosestPair {
    double spacings =
        0;  ///< their distance over the mean spacing; exact if they are alone so close, else a little more
    Neighbor to = Neighbor::fluid;
    Index particle = 0;     ///< index of the fluid particle
    std::size_t count = 0;  ///< fluid particles so close to one another
    bool found = false;
};

template <int Dim>
struct StepContext;

/// Looks at each fluid particle and its neighbours among the fluid, fixed walls, and solids that are the fluid's moving
/// boundary, for those too near. A pass over all pairs.
template <int Dim>
ClosestPair closest_pair(const StepContext<Dim>& c, const Nearness& spacings);

extern template ClosestPair closest_pair<2>(const StepContext<2>&, const Nearness&);
extern template ClosestPair closest_pair<3>(const StepContext<3>&, const Nearness&);

}  // namespace sluice
