#include <cmath>

#include "engine/run/output/probe_sampler.hpp"
#include "engine/scene/formula.hpp"

namespace sluice {
namespace {

/// How far the fluid's velocity is from a stated field: the root of the mean over a body's particles, which all have
/// the same volume within the density's error,
///   e = sqrt( Σ_i |v_i − v(x_i, t)|² / N )   [m/s]
template <int Dim>
class VelocityErrorProbe : public ProbeSampler<Dim> {
  public:
    VelocityErrorProbe(const Probe& probe, const Scene& scene) : name_(probe.name), body_(probe.body.value()) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(Dim); ++k)
            exact_.emplace_back(scene, "probes." + name_ + ".velocity", probe.velocity[k], Variable::place_and_time);
    }

    std::vector<std::string> columns() const override { return {name_ + ".rms [m/s]"}; }

    void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const override {
        const ParticleSet<Dim>& fluid = simulation.fluid();
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < fluid.owned; ++i) {
            if (fluid.body[i] != body_) continue;
            Point at{};
            for (std::size_t k = 0; k < static_cast<std::size_t>(Dim); ++k)
                at[k] = fluid.position[i][static_cast<int>(k)];
            for (std::size_t k = 0; k < static_cast<std::size_t>(Dim); ++k) {
                const double error = fluid.velocity[i][static_cast<int>(k)] - exact_[k].at(at, simulation.time());
                sum += error * error;
            }
            ++count;
        }
        values.push_back(count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0);
    }

  private:
    std::string name_;
    std::size_t body_;
    std::vector<CompiledFormula> exact_;
};

}  // namespace

template <int Dim>
ProbeSamplerPtr<Dim> make_velocity_error_probe(const Probe& probe, const Simulation<Dim>& initial) {
    return std::make_unique<VelocityErrorProbe<Dim>>(probe, initial.scene());
}

template ProbeSamplerPtr<2> make_velocity_error_probe<2>(const Probe&, const Simulation<2>&);
template ProbeSamplerPtr<3> make_velocity_error_probe<3>(const Probe&, const Simulation<3>&);

}  // namespace sluice
