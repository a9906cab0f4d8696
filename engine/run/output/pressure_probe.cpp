#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engine/run/output/probe_sampler.hpp"
#include "kernels/smoothing.hpp"

namespace sluice {
namespace {

template <int Dim>
class PressureProbe : public ProbeSampler<Dim> {
  public:
    explicit PressureProbe(std::string name) : name_(std::move(name)) {}
    std::vector<std::string> columns() const override { return {name_ + ".p [Pa]"}; }

  private:
    std::string name_;
};

/// The pressure at one element of the interface, which moves with its body.
template <int Dim>
class SurfacePressureProbe : public PressureProbe<Dim> {
  public:
    SurfacePressureProbe(const std::string& name, std::size_t element) : PressureProbe<Dim>(name), element_(element) {}

    void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const override {
        values.push_back(simulation.interface().pressure[element_]);
    }

  private:
    std::size_t element_;
};

/// The pressure at a point, as the mean of the fluid around it [Shepard 1968]; 0 where there is none. The factor σ of W
/// is left out, as it cancels:
///   p = Σ_j V_j p_j W_j / Σ_j V_j W_j
template <int Dim>
double fluid_pressure_at(const Simulation<Dim>& simulation, const Vec<Dim>& at) {
    const ParticleSet<Dim>& fluid = simulation.fluid();
    const Smoothing<Dim> w(simulation.scene().method.smoothing_function);
    double sum = 0, weights = 0;
    for (std::size_t j = 0; j < fluid.owned; ++j) {
        const double h = fluid.smoothing_length[j];
        const double shape = w.shape(norm(fluid.position[j] - at) / h);
        if (shape <= 0) continue;
        const double weight = fluid.mass[j] / fluid.density[j] * shape / std::pow(h, Dim);
        sum += weight * fluid.pressure[j];
        weights += weight;
    }
    return weights > 0 ? sum / weights : 0.0;
}

/// The pressure at a fixed point.
template <int Dim>
class FluidPressureProbe : public PressureProbe<Dim> {
  public:
    FluidPressureProbe(const std::string& name, const Vec<Dim>& at) : PressureProbe<Dim>(name), at_(at) {}

    void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const override {
        values.push_back(fluid_pressure_at(simulation, at_));
    }

  private:
    Vec<Dim> at_;
};

/// The pressure of the fluid at a point that moves with the nearest particle of a body's boundary.
template <int Dim>
class BoundaryPressureProbe : public PressureProbe<Dim> {
  public:
    BoundaryPressureProbe(const std::string& name, std::size_t particle, const Vec<Dim>& offset)
        : PressureProbe<Dim>(name), particle_(particle), offset_(offset) {}

    void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const override {
        values.push_back(fluid_pressure_at(simulation, simulation.boundary().position[particle_] + offset_));
    }

  private:
    std::size_t particle_;
    Vec<Dim> offset_;
};

/// The element or boundary particle of this body that is nearest `at`; their number if the body has none.
template <class Surface, int Dim>
std::size_t nearest_of(const Surface& surface, std::size_t body, const Vec<Dim>& at) {
    std::size_t nearest = surface.owned;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < surface.owned; ++k) {
        if (surface.body[k] != body) continue;
        const double distance2 = norm2(surface.position[k] - at);
        if (distance2 >= least) continue;
        least = distance2;
        nearest = k;
    }
    return nearest;
}

}  // namespace

template <int Dim>
ProbeSamplerPtr<Dim> make_pressure_probe(const Probe& probe, const Simulation<Dim>& initial) {
    const Vec<Dim> at = to_vec<Dim>(probe.at);
    if (!probe.body) return std::make_unique<FluidPressureProbe<Dim>>(probe.name, at);
    const std::size_t element = nearest_of(initial.interface(), *probe.body, at);
    if (element < initial.interface().owned) return std::make_unique<SurfacePressureProbe<Dim>>(probe.name, element);
    const ParticleSet<Dim>& boundary = initial.boundary();
    const std::size_t particle = nearest_of(boundary, *probe.body, at);
    if (particle < boundary.owned)
        return std::make_unique<BoundaryPressureProbe<Dim>>(probe.name, particle, at - boundary.position[particle]);
    initial.scene().fail("probes." + probe.name + ".body",
                         fmt::format("found body {}, which has no surface towards a fluid; expected a solid in a "
                                     "scene with fluid, or no body for the pressure at a fixed point",
                                     initial.scene().bodies[*probe.body].name));
}

template ProbeSamplerPtr<2> make_pressure_probe<2>(const Probe&, const Simulation<2>&);
template ProbeSamplerPtr<3> make_pressure_probe<3>(const Probe&, const Simulation<3>&);

}  // namespace sluice
