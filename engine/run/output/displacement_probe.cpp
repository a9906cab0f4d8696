#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/geometry/moving_least_squares.hpp"
#include "engine/particles/id_index.hpp"
#include "engine/run/output/probe_sampler.hpp"

namespace sluice {
namespace {

/// Particles of one body in the initial configuration.
template <int Dim>
struct BodyPoints {
    std::vector<Vec<Dim>> position;
    std::vector<std::uint64_t> id;
    double smoothing_length = 0;  ///< largest
};

template <int Dim>
BodyPoints<Dim> points_of(const ParticleSet<Dim>& solid, std::size_t body) {
    BodyPoints<Dim> points;
    for (std::size_t i = 0; i < solid.owned; ++i) {
        if (solid.body[i] != body) continue;
        points.position.push_back(solid.position[i]);
        points.id.push_back(solid.id[i]);
        points.smoothing_length = std::max(points.smoothing_length, solid.smoothing_length[i]);
    }
    return points;
}

template <int Dim>
double distance_to(const std::vector<Vec<Dim>>& points, const Vec<Dim>& at) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec<Dim>& point : points) least = std::min(least, norm(point - at));
    return least;
}

/// A particle's share in the probe's displacement.
template <int Dim>
struct MaterialShare {
    std::uint64_t id;
    double weight;
    Vec<Dim> initial;
};

template <int Dim>
class DisplacementProbe : public ProbeSampler<Dim> {
  public:
    DisplacementProbe(std::string name, std::vector<MaterialShare<Dim>> shares)
        : name_(std::move(name)), shares_(std::move(shares)) {}

    std::vector<std::string> columns() const override { return vector_columns<Dim>(name_, "m"); }

    /// u = Σ_i w_i (x_i − X_i)
    void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const override {
        Vec<Dim> u;
        for (const MaterialShare<Dim>& share : shares_) {
            const Index i = simulation.solid_index_of_id()[share.id];
            u += share.weight * (simulation.solid().position[i] - share.initial);
        }
        values.insert(values.end(), u.c.begin(), u.c.end());
    }

  private:
    std::string name_;
    std::vector<MaterialShare<Dim>> shares_;
};

}  // namespace

template <int Dim>
ProbeSamplerPtr<Dim> make_displacement_probe(const Probe& probe, const Simulation<Dim>& initial) {
    const Scene& scene = initial.scene();
    const std::string& body = scene.bodies[probe.body.value()].name;
    const BodyPoints<Dim> points = points_of(initial.solid(), probe.body.value());
    const Vec<Dim> at = to_vec<Dim>(probe.at);
    const double support = 2 * points.smoothing_length;
    const double distance = distance_to(points.position, at);
    // A corner is d·sqrt(Dim)/2 from the nearest particle; beyond the support there is nothing to extrapolate from.
    if (distance >= support)
        scene.fail(
            "probes." + probe.name + ".at",
            fmt::format("found a point {:.3g} m away from body {}, expected a point of the body", distance, body));
    // Each time the radius grows by half a spacing or so; a body that is flat even in 8 supports is a thread.
    for (double radius = support; radius < 8 * support; radius *= 1.2) {
        const auto shares = least_squares_shares(points.position, at, radius);
        if (!shares) continue;
        std::vector<MaterialShare<Dim>> material;
        for (const Share& share : *shares)
            material.push_back({points.id[share.point], share.weight, points.position[share.point]});
        return std::make_unique<DisplacementProbe<Dim>>(probe.name, std::move(material));
    }
    scene.fail("probes." + probe.name + ".at",
               fmt::format("found particles of body {} that do not span {} dimensions around the point, expected a "
                           "smaller spacing",
                           body, Dim));
}

template ProbeSamplerPtr<2> make_displacement_probe<2>(const Probe&, const Simulation<2>&);
template ProbeSamplerPtr<3> make_displacement_probe<3>(const Probe&, const Simulation<3>&);

}  // namespace sluice
