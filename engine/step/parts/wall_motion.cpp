#include "engine/step/parts/wall_motion.hpp"

#include <algorithm>

namespace sluice {

template <int Dim>
WallMotion<Dim>::WallMotion(const Scene& scene, const Wall& wall) : motion_(wall.motion) {
    if (!motion_.time.empty()) return;
    for (std::size_t k = 0; k < Dim; ++k)
        formulas_.emplace_back(scene, "walls." + wall.name + ".motion.displacement", motion_.displacement[k],
                               Variable::time);
}

template <int Dim>
Vec<Dim> WallMotion<Dim>::displacement(double t) const {
    Vec<Dim> x;
    if (!formulas_.empty()) {
        for (int k = 0; k < Dim; ++k) x[k] = formulas_[static_cast<std::size_t>(k)](t);
        return x;
    }
    const auto& times = motion_.time;
    const auto after = std::upper_bound(times.begin(), times.end(), t);
    const auto row = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(after - times.begin(), 1, static_cast<std::ptrdiff_t>(times.size()) - 1));
    const double share = std::clamp((t - times[row - 1]) / (times[row] - times[row - 1]), 0.0, 1.0);
    for (int k = 0; k < Dim; ++k) {
        const auto c = static_cast<std::size_t>(k);
        x[k] = (1 - share) * motion_.place[row - 1][c] + share * motion_.place[row][c];
    }
    return x;
}

template class WallMotion<2>;
template class WallMotion<3>;

}  // namespace sluice
