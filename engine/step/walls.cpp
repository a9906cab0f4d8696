#include "engine/step/walls.hpp"

#include <algorithm>

#include "kernels/passes/boundary_passes.hpp"
#include "kernels/passes/wall_passes.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
WallPart<Dim>::WallPart(StepContext<Dim>& context) : c_(context) {
    if (!c_.has(Effect::moving_wall)) return;
    for (const Wall& wall : c_.scene.walls) {
        motion_.emplace_back();
        if (!wall.motion.moves()) continue;
        motion_.back().emplace(c_.scene, wall);
        if (norm(motion_.back()->displacement(0)) > 0)
            c_.scene.fail("walls." + wall.name + ".motion",
                          "found a displacement at t = 0, expected none: the shape states where the wall starts");
    }
    for (auto* column : {&displacement_, &velocity_, &acceleration_, &effective_gravity_})
        column->resize(motion_.size());
    finish(0);
}

template <int Dim>
double WallPart<Dim>::move_halfway(double t) {
    if (motion_.empty()) return 0;
    const auto scope = c_.timer.measure(StepPhase::wall_pass);
    const double dt = c_.plan.dt;
    double farthest = 0;
    for (std::size_t w = 0; w < motion_.size(); ++w) {
        if (!motion_[w]) continue;
        const Vec<Dim> from = motion_[w]->displacement(t), to = motion_[w]->displacement(t + dt);
        const Vec<Dim> mean = (1 / dt) * (to - from);
        acceleration_[w] = (1 / dt) * (mean - velocity_[w]);
        velocity_[w] = mean;
        displacement_[w] = 0.5 * (from + to);
        farthest = std::max(farthest, norm(to - from));
    }
    place();
    return farthest;
}

template <int Dim>
void WallPart<Dim>::finish(double t) {
    if (motion_.empty()) return;
    const auto scope = c_.timer.measure(StepPhase::wall_pass);
    for (std::size_t w = 0; w < motion_.size(); ++w)
        if (motion_[w]) displacement_[w] = motion_[w]->displacement(t);
    place();
}

template <int Dim>
void WallPart<Dim>::place() {
    auto& wall = c_.state.wall;
    parallel_for(wall.owned, [&](std::size_t i) {
        wall.position.set(i, wall.initial_position[i] + displacement_[wall.body[i]]);
        wall.velocity.set(i, velocity_[wall.body[i]]);
    });
    c_.state.wall.refresh_ghosts(column::position, column::velocity);
}

template <int Dim>
void WallPart<Dim>::forces() {
    if (!c_.has(Effect::fixed_wall)) return;
    const auto scope = c_.timer.measure(StepPhase::wall_pass);
    auto& wall = c_.state.wall;
    auto& fluid = c_.state.fluid;
    const Vec<Dim> gravity = c_.state.gravity;
    const NeighborList& list = c_.neighbors.wall_fluid;
    if (motion_.empty())
        c_.pairs += fixed_ghost_pressure<Dim>(view_of(wall), view_of(fluid), list, gravity, c_.method, wall.pressure);
    else {
        for (std::size_t w = 0; w < motion_.size(); ++w) effective_gravity_[w] = gravity - acceleration_[w];
        c_.pairs += moving_ghost_pressure<Dim>(view_of(wall), view_of(fluid), list, effective_gravity_, wall.body,
                                               c_.method, wall.pressure);
    }
    c_.state.wall.refresh_ghosts(column::pressure);
    c_.pairs +=
        fixed_ghost_force<Dim>(view_of(fluid), view_of(wall), c_.neighbors.fluid_wall, c_.method, fluid.acceleration);
    if (c_.has(Effect::no_slip_wall)) friction();
}

template <int Dim>
void WallPart<Dim>::friction() {
    auto& wall = c_.state.wall;
    auto& fluid = c_.state.fluid;
    const bool moving = c_.has(Effect::moving_wall);
    parallel_for(wall.owned,
                 [&](std::size_t i) { wall.ghost_velocity.set(i, moving ? wall.velocity[i] : Vec<Dim>{}); });
    ParticleView<Dim> ghosts = view_of(wall);
    ghosts.velocity = columns_of(wall.ghost_velocity);
    boundary_ghost_velocity<Dim>(ghosts, view_of(fluid), c_.neighbors.wall_fluid, c_.method, wall.ghost_velocity);
    c_.state.wall.refresh_ghosts(column::ghost_velocity);
    ghosts = view_of(wall);
    ghosts.velocity = columns_of(wall.ghost_velocity);
    ghosts.volume = wall.friction_volume.data();
    boundary_friction<Dim>(view_of(fluid), ghosts, c_.neighbors.fluid_wall, c_.state.water->viscosity, c_.method,
                           block_totals_, fluid.acceleration);
}

template <int Dim>
void WallPart<Dim>::rates() {
    if (!c_.has(Effect::fixed_wall)) return;
    const auto scope = c_.timer.measure(StepPhase::wall_pass);
    auto& fluid = c_.state.fluid;
    const auto fluid_view = view_of(fluid), wall_view = view_of(c_.state.wall);
    const NeighborList& list = c_.neighbors.fluid_wall;
    if (motion_.empty())
        c_.pairs += fixed_ghost_continuity<Dim>(fluid_view, wall_view, list, c_.method, fluid.density_rate);
    else
        boundary_continuity<Dim>(fluid_view, wall_view, list, c_.method, fluid.density_rate);
}

template class WallPart<2>;
template class WallPart<3>;

}  // namespace sluice
