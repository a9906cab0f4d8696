#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/run/output/probe_sampler.hpp"

namespace sluice {
namespace {

struct Range {
    double min, max;
    double length() const { return max - min; }
};

/// Axes along the ground: x, in 3D also z. Height is along y.
template <int Dim>
constexpr auto ground_axes() {
    if constexpr (Dim == 2)
        return std::array<int, 1>{0};
    else
        return std::array<int, 2>{0, 2};
}
template <int Dim>
using Footprint = std::array<Range, Dim - 1>;

/// A mirror wall counts as square to an axis if its unit normal is so to this accuracy; oblique walls do not cut.
constexpr double square_to_axis = 1e-9;

/// The part of [min, max] along one axis that is on the fluid's side of the mirror walls.
void cut_by_walls(Range& range, const std::vector<Wall>& walls, int axis) {
    const auto a = static_cast<std::size_t>(axis);
    for (const Wall& wall : walls) {
        if (wall.kind != WallKind::mirror || std::abs(std::abs(wall.normal[a]) - 1) > square_to_axis) continue;
        if (wall.normal[a] > 0)
            range.min = std::max(range.min, wall.point[a]);
        else
            range.max = std::min(range.max, wall.point[a]);
    }
}

template <int Dim>
double largest_smoothing_length(const ParticleSet<Dim>& fluid) {
    double h = 0;
    for (std::size_t j = 0; j < fluid.owned; ++j) h = std::max(h, fluid.smoothing_length[j]);
    return h;
}

/// Part of a particle, a square of this side, that stands on the footprint.
template <int Dim>
double part_inside(const Footprint<Dim>& footprint, const Vec<Dim>& position, double side) {
    double part = 1;
    for (std::size_t k = 0; k < footprint.size(); ++k) {
        const double x = position[ground_axes<Dim>()[k]];
        const double overlap = std::min(footprint[k].max, x + side / 2) - std::max(footprint[k].min, x - side / 2);
        part *= std::clamp(overlap / side, 0.0, 1.0);
    }
    return part;
}

/// Volume of water on a strip of ground by the strip's width (in 3D: on a rectangle by its area). With the volumes m/ρ0
/// the level answers to mass alone, not to the pressure.
template <int Dim>
class LevelProbe : public ProbeSampler<Dim> {
  public:
    LevelProbe(std::string name, const Footprint<Dim>& footprint) : name_(std::move(name)), footprint_(footprint) {}

    std::vector<std::string> columns() const override { return {name_ + ".level [m]"}; }

    void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const override {
        const ParticleSet<Dim>& fluid = simulation.fluid();
        const Scene& scene = simulation.scene();
        double volume = 0;
        for (std::size_t j = 0; j < fluid.owned; ++j) {
            const double v = fluid.mass[j] / scene.materials[scene.bodies[fluid.body[j]].material].density;
            volume += v * part_inside<Dim>(footprint_, fluid.position[j], Dim == 2 ? std::sqrt(v) : std::cbrt(v));
        }
        double area = 1;
        for (const Range& range : footprint_) area *= range.length();
        values.push_back(volume / area);
    }

  private:
    std::string name_;
    Footprint<Dim> footprint_;
};

}  // namespace

template <int Dim>
ProbeSamplerPtr<Dim> make_level_probe(const Probe& probe, const Simulation<Dim>& initial) {
    const double half_width = 2 * largest_smoothing_length(initial.fluid());
    Footprint<Dim> footprint;
    for (std::size_t k = 0; k < footprint.size(); ++k) {
        const int axis = ground_axes<Dim>()[k];
        const double centre = probe.at[static_cast<std::size_t>(axis)];
        footprint[k] = {centre - half_width, centre + half_width};
        cut_by_walls(footprint[k], initial.scene().walls, axis);
        if (footprint[k].length() <= 0)
            initial.scene().fail("probes." + probe.name + ".at",
                                 fmt::format("found {} = {} behind a mirror wall, expected a place where water can be",
                                             "xyz"[axis], centre));
    }
    return std::make_unique<LevelProbe<Dim>>(probe.name, footprint);
}

template ProbeSamplerPtr<2> make_level_probe<2>(const Probe&, const Simulation<2>&);
template ProbeSamplerPtr<3> make_level_probe<3>(const Probe&, const Simulation<3>&);

}  // namespace sluice
