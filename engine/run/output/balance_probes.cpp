#include "engine/run/output/probe_sampler.hpp"

namespace sluice {
namespace {

/// In 2D everything is per metre of width.
template <int Dim>
constexpr const char* unit(const char* in_3d, const char* in_2d) {
    return Dim == 3 ? in_3d : in_2d;
}

template <int Dim>
class EnergyProbe : public ProbeSampler<Dim> {
  public:
    explicit EnergyProbe(std::string name) : name_(std::move(name)) {}

    std::vector<std::string> columns() const override {
        std::vector<std::string> columns;
        for (const char* part : {"kinetic", "potential", "compression", "elastic", "contact", "total"})
            columns.push_back(name_ + "." + part + " [" + unit<Dim>("J", "J/m") + "]");
        return columns;
    }

    void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const override {
        const EnergyBalance e = simulation.energy();
        values.insert(values.end(), {e.kinetic, e.potential, e.compression, e.elastic, e.contact, e.total()});
    }

  private:
    std::string name_;
};

template <int Dim>
class MomentumProbe : public ProbeSampler<Dim> {
  public:
    explicit MomentumProbe(std::string name) : name_(std::move(name)) {}

    std::vector<std::string> columns() const override {
        return vector_columns<Dim>(name_, unit<Dim>("kg m/s", "kg/s"));
    }

    void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const override {
        const Vec<Dim> p = simulation.momentum();
        values.insert(values.end(), p.c.begin(), p.c.end());
    }

  private:
    std::string name_;
};

template <int Dim>
class ForceProbe : public ProbeSampler<Dim> {
  public:
    ForceProbe(std::string name, std::size_t body) : name_(std::move(name)), body_(body) {}

    std::vector<std::string> columns() const override { return vector_columns<Dim>(name_, unit<Dim>("N", "N/m")); }

    void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const override {
        const Vec<Dim> f = simulation.force_on(body_);
        values.insert(values.end(), f.c.begin(), f.c.end());
    }

  private:
    std::string name_;
    std::size_t body_;
};

}  // namespace

template <int Dim>
ProbeSamplerPtr<Dim> make_energy_probe(const Probe& probe) {
    return std::make_unique<EnergyProbe<Dim>>(probe.name);
}

template <int Dim>
ProbeSamplerPtr<Dim> make_momentum_probe(const Probe& probe) {
    return std::make_unique<MomentumProbe<Dim>>(probe.name);
}

template <int Dim>
ProbeSamplerPtr<Dim> make_force_probe(const Probe& probe) {
    return std::make_unique<ForceProbe<Dim>>(probe.name, probe.body.value());
}

template ProbeSamplerPtr<2> make_energy_probe<2>(const Probe&);
template ProbeSamplerPtr<3> make_energy_probe<3>(const Probe&);
template ProbeSamplerPtr<2> make_momentum_probe<2>(const Probe&);
template ProbeSamplerPtr<3> make_momentum_probe<3>(const Probe&);
template ProbeSamplerPtr<2> make_force_probe<2>(const Probe&);
template ProbeSamplerPtr<3> make_force_probe<3>(const Probe&);

}  // namespace sluice
