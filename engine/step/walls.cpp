#include "engine/step/walls.hpp"

#include "kernels/wall_passes.hpp"

namespace sluice {

template <int Dim>
void WallPart<Dim>::forces() {
    if (!c_.has(Effect::fixed_wall)) return;
    const auto scope = c_.timer.measure(StepPhase::wall_pass);
    auto& wall = c_.state.wall;
    auto& fluid = c_.state.fluid;
    c_.pairs += fixed_ghost_pressure<Dim>(view_of(wall), view_of(fluid), c_.neighbors.wall_fluid, c_.state.gravity,
                                          c_.method, wall.pressure);
    c_.neighbors.refresh_wall_pressure();
    c_.pairs +=
        fixed_ghost_force<Dim>(view_of(fluid), view_of(wall), c_.neighbors.fluid_wall, c_.method, fluid.acceleration);
}

template <int Dim>
void WallPart<Dim>::rates() {
    if (!c_.has(Effect::fixed_wall)) return;
    const auto scope = c_.timer.measure(StepPhase::wall_pass);
    auto& fluid = c_.state.fluid;
    c_.pairs += fixed_ghost_continuity<Dim>(view_of(fluid), view_of(c_.state.wall), c_.neighbors.fluid_wall, c_.method,
                                            fluid.density_rate);
}

template class WallPart<2>;
template class WallPart<3>;

}  // namespace sluice
