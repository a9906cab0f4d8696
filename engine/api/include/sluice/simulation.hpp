// A scene that is stepped through time.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "field.hpp"
#include "scene.hpp"

namespace sluice::api {

/// Of all moving particles, by form. [J; J/m in 2D]
struct Energy {
    double kinetic = 0;
    double potential = 0;
    double compression = 0;
    double elastic = 0;
    double contact = 0;
    double total() const { return kinetic + potential + compression + elastic + contact; }
};

/// Asked after each step; false ends the advance.
using GoOn = std::function<bool()>;

/// Particles and the steps that move them. Writes no files (see run.hpp for that). Not to be used from two threads at
/// once; the loops inside are parallel.
class SLUICE_API Simulation {
  public:
    /// Places the particles. `threads`: 0 = as many as OpenMP offers. Throws SceneError.
    explicit Simulation(const Scene& scene, int threads = 0);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Takes so many steps. Every fifty the state is looked at, as in a run: throws NumericalError when it has become
    /// meaningless.
    void advance(std::uint64_t steps, const GoOn& go_on = {});
    /// Steps until that time is reached within half a step [s]; throws std::invalid_argument if it is not finite.
    void advance_to(double time, const GoOn& go_on = {});
    /// What has looked wrong so far, with cause and remedy.
    std::vector<std::string> warnings() const;

    const Scene& scene() const;
    double time() const;          ///< simulated so far [s]
    double time_step() const;     ///< of the last step; before it, of the first [s]
    std::uint64_t steps() const;  ///< taken so far
    Energy energy() const;
    std::array<double, 3> momentum() const;        ///< of all moving particles [kg m/s; kg/s in 2D]
    std::vector<std::string> probe_names() const;  ///< columns of probes.csv, with units
    std::vector<double> probe_values() const;      ///< one per name, of now
    std::size_t memory_bytes() const;              ///< of fields and neighbour lists

    std::size_t particles(Medium medium) const;  ///< their number
    /// Names of the fields that this scene has.
    std::vector<std::string> fields(Medium medium) const;
    /// Without copying. Throws std::out_of_range for a name that `fields` does not list.
    Field field(Medium medium, const std::string& name) const;
    /// What a frame written now would hold; a copy.
    Frame frame() const;

  private:
    struct Impl;
    template <int Dim>
    struct ImplOf;
    std::shared_ptr<Impl> impl_;  ///< shared with the columns that were handed out
};

}  // namespace sluice::api
