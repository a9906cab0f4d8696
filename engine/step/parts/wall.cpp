#include "engine/step/parts/wall.hpp"

#include <algorithm>

#include "engine/files/state_visitors.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {

template <int Dim>
WallPart<Dim>::WallPart(StepContext<Dim>& context) : c_(context) {
    for (const Wall& wall : c_.scene.walls) {
        motion_.emplace_back();
        if (!wall.motion.moves()) continue;
        motion_.back().emplace(c_.scene, wall);
        if (norm(motion_.back()->displacement(0)) > 0)
            c_.scene.fail("walls." + wall.name + ".motion",
                          "found a displacement at t = 0, expected none: the shape states where the wall starts");
    }
    for (auto* column : {&displacement_, &velocity_, &c_.wall_acceleration}) column->resize(motion_.size());
}

template <int Dim>
void WallPart<Dim>::start() {
    finish(0);
}

template <int Dim>
void WallPart<Dim>::first_half() {
    const auto scope = c_.timer.measure(StepPhase::wall_pass);
    const double dt = c_.plan.dt;
    double farthest = 0;
    for (std::size_t w = 0; w < motion_.size(); ++w) {
        if (!motion_[w]) continue;
        const Vec<Dim> from = motion_[w]->displacement(c_.time), to = motion_[w]->displacement(c_.time + dt);
        const Vec<Dim> mean = (1 / dt) * (to - from);
        c_.wall_acceleration[w] = (1 / dt) * (mean - velocity_[w]);
        velocity_[w] = mean;
        displacement_[w] = 0.5 * (from + to);
        farthest = std::max(farthest, norm(to - from));
    }
    place();
    c_.motion.wall = farthest;
}

template <int Dim>
void WallPart<Dim>::second_half() {
    finish(c_.end);
}

template <int Dim>
void WallPart<Dim>::finish(double t) {
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
    wall.refresh_ghosts(column::position, column::velocity);
}

template <int Dim>
void WallPart<Dim>::save(const StateWriter& writer) {
    visit_state(writer);
}
template <int Dim>
void WallPart<Dim>::restore(const StateReader& reader) {
    visit_state(reader);
}

template class WallPart<2>;
template class WallPart<3>;

}  // namespace sluice
