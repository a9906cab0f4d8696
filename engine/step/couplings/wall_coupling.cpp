#include "engine/step/couplings/wall_coupling.hpp"

#include "kernels/passes/boundary_passes.hpp"
#include "kernels/passes/wall_passes.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
WallCoupling<Dim>::WallCoupling(StepContext<Dim>& context)
    : c_(context),
      of_fluid_(context.neighbors.pair({SetId::fluid, SetId::wall}).list),
      of_walls_(context.neighbors.pair({SetId::wall, SetId::fluid}).list) {}

template <int Dim>
void WallCoupling<Dim>::forces() {
    const auto scope = c_.timer.measure(StepPhase::wall_pass);
    auto& wall = c_.state.wall;
    auto& fluid = c_.state.fluid;
    const Vec<Dim> gravity = c_.state.gravity;
    if (!c_.has(Effect::moving_wall))
        c_.pairs +=
            fixed_ghost_pressure<Dim>(view_of(wall), view_of(fluid), of_walls_, gravity, c_.method, wall.pressure);
    else {
        effective_gravity_.resize(c_.wall_acceleration.size());
        for (std::size_t w = 0; w < effective_gravity_.size(); ++w)
            effective_gravity_[w] = gravity - c_.wall_acceleration[w];
        c_.pairs += moving_ghost_pressure<Dim>(view_of(wall), view_of(fluid), of_walls_, effective_gravity_, wall.body,
                                               c_.method, wall.pressure);
    }
    wall.refresh_ghosts(column::pressure);
    c_.pairs += fixed_ghost_force<Dim>(view_of(fluid), view_of(wall), of_fluid_, c_.method, fluid.acceleration);
    if (c_.has(Effect::no_slip_wall)) friction();
}

template <int Dim>
void WallCoupling<Dim>::friction() {
    auto& wall = c_.state.wall;
    auto& fluid = c_.state.fluid;
    const bool moving = c_.has(Effect::moving_wall);
    parallel_for(wall.owned,
                 [&](std::size_t i) { wall.ghost_velocity.set(i, moving ? wall.velocity[i] : Vec<Dim>{}); });
    ParticleView<Dim> particles = view_of(wall);
    particles.velocity = columns_of(wall.ghost_velocity);
    boundary_ghost_velocity<Dim>(particles, view_of(fluid), of_walls_, c_.method, wall.ghost_velocity);
    wall.refresh_ghosts(column::ghost_velocity);
    particles = view_of(wall);
    particles.velocity = columns_of(wall.ghost_velocity);
    particles.volume = wall.friction_volume.data();
    boundary_friction<Dim>(view_of(fluid), particles, of_fluid_, c_.state.fluid_materials.front().viscosity, c_.method,
                           block_totals_, fluid.acceleration);
    c_.pairs += of_walls_.pairs() + of_fluid_.pairs();
}

template <int Dim>
void WallCoupling<Dim>::rates() {
    const auto scope = c_.timer.measure(StepPhase::wall_pass);
    auto& fluid = c_.state.fluid;
    const auto fluid_view = view_of(fluid), wall_view = view_of(c_.state.wall);
    if (!c_.has(Effect::moving_wall)) {
        c_.pairs += fixed_ghost_continuity<Dim>(fluid_view, wall_view, of_fluid_, c_.method, fluid.density_rate);
        return;
    }
    boundary_continuity<Dim>(fluid_view, wall_view, of_fluid_, c_.method, fluid.density_rate);
    c_.pairs += of_fluid_.pairs();
}

template class WallCoupling<2>;
template class WallCoupling<3>;

}  // namespace sluice
