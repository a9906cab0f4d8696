// What a probe measures, apart from where its values go.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/simulation/simulation.hpp"

namespace sluice {

/// One probe of a scene, bound to the particles of the initial configuration.
template <int Dim>
class ProbeSampler {
  public:
    virtual ~ProbeSampler() = default;
    /// Names with units, one per value.
    virtual std::vector<std::string> columns() const = 0;
    /// Adds the present values, one per column.
    virtual void sample(const Simulation<Dim>& simulation, std::vector<double>& values) const = 0;
};

template <int Dim>
using ProbeSamplerPtr = std::unique_ptr<const ProbeSampler<Dim>>;

/// Displacement of a material point of a solid body [m]. Throws SceneError if the point is off the body.
template <int Dim>
ProbeSamplerPtr<Dim> make_displacement_probe(const Probe& probe, const Simulation<Dim>& initial);

/// Pressure on a body's surface, or in the fluid at a fixed point [Pa].
template <int Dim>
ProbeSamplerPtr<Dim> make_pressure_probe(const Probe& probe, const Simulation<Dim>& initial);

/// Depth of the water above a point of the ground [m]. Throws SceneError if the point is behind a mirror wall.
template <int Dim>
ProbeSamplerPtr<Dim> make_level_probe(const Probe& probe, const Simulation<Dim>& initial);

/// How far the velocity of a fluid body is from a stated field [m/s].
template <int Dim>
ProbeSamplerPtr<Dim> make_velocity_error_probe(const Probe& probe, const Simulation<Dim>& initial);

/// Energy, momentum, and the fluid's force on a body.
template <int Dim>
ProbeSamplerPtr<Dim> make_energy_probe(const Probe& probe);
template <int Dim>
ProbeSamplerPtr<Dim> make_momentum_probe(const Probe& probe);
template <int Dim>
ProbeSamplerPtr<Dim> make_force_probe(const Probe& probe);

/// A scene's position as a vector.
template <int Dim>
Vec<Dim> to_vec(const Point& p) {
    Vec<Dim> v;
    for (int k = 0; k < Dim; ++k) v[k] = p[static_cast<std::size_t>(k)];
    return v;
}

/// NAME.x [unit], NAME.y [unit] …
template <int Dim>
std::vector<std::string> vector_columns(const std::string& name, const std::string& unit) {
    std::vector<std::string> columns;
    for (int k = 0; k < Dim; ++k) columns.push_back(name + "." + "xyz"[k] + " [" + unit + "]");
    return columns;
}

}  // namespace sluice
