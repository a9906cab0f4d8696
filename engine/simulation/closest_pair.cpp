#include "engine/simulation/closest_pair.hpp"

#include <algorithm>
#include <cmath>

#include "engine/step/context.hpp"
#include "kernels/passes/crowding_passes.hpp"

namespace sluice {

namespace {

/// Whether fluid pairs with what is asked for.
template <int Dim>
bool has_neighbor(const StepContext<Dim>& c, Neighbor to) {
    switch (to) {
        case Neighbor::fluid:
            return true;
        case Neighbor::solid:
            return c.has(Effect::moving_boundary);
        case Neighbor::wall:
            return c.has(Effect::fixed_wall);
    }
    return {};
}

}  // namespace

template <int Dim>
ClosestPair closest_pair(const StepContext<Dim>& c, Neighbor to, double spacings, const CountsHere& counts) {
    if (!has_neighbor(c, to)) return {};
    const auto& fluid = c.state.fluid;
    const double of_itself = to == Neighbor::fluid ? 1 : 0;  // a particle is its own neighbour
    ScalarField crowding(fluid.owned, of_itself);
    const auto look = [&](const ParticleView<Dim>& others, const NeighborList& list) {
        crowding_of<Dim>(view_of(fluid), others, list, spacings / c.scene.method.smoothing_length, crowding);
    };
    switch (to) {
        case Neighbor::fluid:
            look(view_of(fluid), c.neighbors.pair({SetId::fluid, SetId::fluid}).list);
            break;
        case Neighbor::solid:
            look(view_of(c.state.boundary),
                 c.neighbors.pair({SetId::fluid, SetId::boundary, Upkeep::coupling, Targets::own}).list);
            break;
        case Neighbor::wall:
            look(view_of(c.state.wall), c.neighbors.pair({SetId::fluid, SetId::wall}).list);
            break;
    }
    if (counts)
        for (Index i = 0; i < crowding.size(); ++i)
            if (crowding[i] > of_itself && !counts(i)) crowding[i] = of_itself;
    const auto count = std::count_if(crowding.begin(), crowding.end(), [&](double sum) { return sum > of_itself; });
    if (count == 0) return {};
    const auto most = std::max_element(crowding.begin(), crowding.end());
    const double nearness = std::min(1.0, *most - of_itself);
    return {static_cast<std::size_t>(count), spacings * std::sqrt(1 - nearness),
            static_cast<Index>(most - crowding.begin())};
}

template ClosestPair closest_pair<2>(const StepContext<2>&, Neighbor, double, const CountsHere&);
template ClosestPair closest_pair<3>(const StepContext<3>&, Neighbor, double, const CountsHere&);

}  // namespace sluice
