#include "engine/run/watch/inside_walls.hpp"

#include <algorithm>

namespace sluice {
namespace {

template <int Dim>
bool contains(const Shape& shape, const Vec<Dim>& x) {
    Point p{};
    for (int k = 0; k < Dim; ++k) p[static_cast<std::size_t>(k)] = x[k];
    return shape.contains(p);
}

}  // namespace

template <int Dim>
InsideWalls<Dim>::InsideWalls(const Simulation<Dim>& simulation) {
    const Scene& scene = simulation.scene();
    const auto& particles = simulation.wall();
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        const Wall& wall = scene.walls[w];
        if (wall.kind != WallKind::fixed) continue;
        parts_.push_back({wall.shape.get(), depth * wall.spacing, {}});
        if (!wall.motion.moves()) continue;
        for (std::size_t i = 0; i < particles.owned; ++i)
            if (particles.body[i] == w) {
                parts_.back().displacement = particles.position[i] - particles.initial_position[i];
                break;
            }
    }
}

template <int Dim>
bool InsideWalls<Dim>::in_any(const Vec<Dim>& x) const {
    return std::any_of(parts_.begin(), parts_.end(),
                       [&](const Part& part) { return contains<Dim>(*part.shape, x - part.displacement); });
}

/// Along the axes only: behind a slanting face that is a little less deep.
template <int Dim>
bool InsideWalls<Dim>::operator()(const Vec<Dim>& x) const {
    const auto around = std::find_if(parts_.begin(), parts_.end(), [&](const Part& part) {
        return contains<Dim>(*part.shape, x - part.displacement);
    });
    if (around == parts_.end()) return false;
    for (int k = 0; k < Dim; ++k)
        for (const double side : {-around->depth, around->depth}) {
            Vec<Dim> beside = x;
            beside[k] += side;
            if (!in_any(beside)) return false;
        }
    return true;
}

template class InsideWalls<2>;
template class InsideWalls<3>;

}  // namespace sluice
