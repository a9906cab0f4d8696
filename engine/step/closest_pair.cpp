#include "engine/step/closest_pair.hpp"

#include <algorithm>
#include <cmath>

#include "engine/step/context.hpp"
#include "kernels/crowding_passes.hpp"

namespace sluice {

template <int Dim>
ClosestPair closest_pair(const StepContext<Dim>& c, const Nearness& spacings) {
    const auto& fluid = c.state.fluid;
    ClosestPair closest;
    std::size_t among_fluid = 0;
    ScalarField crowding(fluid.owned);
    const auto look = [&](const ParticleView<Dim>& others, const NeighborList& list, Neighbor to, double of_itself) {
        const double limit = to == Neighbor::fluid ? spacings.fluid : spacings.boundary;
        std::fill(crowding.begin(), crowding.end(), of_itself);
        crowding_of<Dim>(view_of(fluid), others, list, limit / c.scene.method.smoothing_length, crowding);
        const auto most = std::max_element(crowding.begin(), crowding.end());
        const double excess = most == crowding.end() ? 0 : *most - of_itself;
        if (!(excess > 0)) return;
        if (to == Neighbor::fluid)
            among_fluid = static_cast<std::size_t>(
                std::count_if(crowding.begin(), crowding.end(), [&](double sum) { return sum > of_itself; }));
        const double distance = limit * std::sqrt(std::max(0.0, 1 - excess));
        if (closest.found && distance >= closest.spacings) return;
        closest = {distance, to, static_cast<Index>(most - crowding.begin()), 0, true};
    };
    look(view_of(fluid), c.neighbors.fluid_fluid, Neighbor::fluid, 1);
    if (c.has(Effect::fixed_wall)) look(view_of(c.state.wall), c.neighbors.fluid_wall, Neighbor::wall, 0);
    if (c.has(Effect::moving_boundary)) look(view_of(c.state.boundary), c.neighbors.fluid_boundary, Neighbor::solid, 0);
    closest.count = among_fluid;
    return closest;
}

template ClosestPair closest_pair<2>(const StepContext<2>&, const Nearness&);
template ClosestPair closest_pair<3>(const StepContext<3>&, const Nearness&);

}  // namespace sluice
