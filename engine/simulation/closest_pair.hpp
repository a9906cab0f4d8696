// The closest pair of particles, among those that have come too close.
#pragma once

#include <functional>

#include "neighbor/fields.hpp"

namespace sluice {

/// What a fluid particle may have come too close to.
enum class Neighbor { fluid, solid, wall };

struct ClosestPair {
    std::size_t count = 0;  ///< fluid particles that are too close; 0 = there is no such pair
    double spacings =
        0;               ///< the closest one's distance over the mean spacing; a little less if it has several so close
    Index particle = 0;  ///< index of the fluid particle
};

/// Which fluid particles count, by their index; all if it is empty.
using CountsHere = std::function<bool(Index)>;

template <int Dim>
struct StepContext;

/// Searches each fluid particle's neighbours, in the fluid, in fixed walls or in solids that are its moving boundary,
/// for those nearer than this many spacings; finds none if the scene has no such neighbours. Takes one pass over pairs;
/// `counts` is called only for particles that are too close.
template <int Dim>
ClosestPair closest_pair(const StepContext<Dim>& c, Neighbor to, double spacings, const CountsHere& counts = {});

extern template ClosestPair closest_pair<2>(const StepContext<2>&, Neighbor, double, const CountsHere&);
extern template ClosestPair closest_pair<3>(const StepContext<3>&, Neighbor, double, const CountsHere&);

}  // namespace sluice
