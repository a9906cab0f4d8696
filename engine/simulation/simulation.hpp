// A scene brought to life: particles, effects and the step that advances them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/particles/particle_set.hpp"
#include "engine/scene/scene.hpp"
#include "engine/simulation/closest_pair.hpp"
#include "engine/step/energy_balance.hpp"
#include "engine/step/interface_balance.hpp"
#include "engine/step/step_plan.hpp"

namespace sluice {

/// The work done in a run so far.
struct WorkCount {
    std::uint64_t steps = 0;
    std::uint64_t particle_steps = 0;  ///< fluid and solid particles advanced, the solid's by sub-steps
    std::uint64_t pairs = 0;           ///< directed pairs inside the support, summed over all pair passes
    std::uint64_t neighbour_builds = 0;
};

class Effects;
class IdIndex;
class MaterialList;
class PhaseTimer;
class StateReader;
class StateWriter;
struct PartRange;

template <int Dim>
class Simulation {
  public:
    /// Places the particles. Throws SceneError for bodies that overlap or are too thin.
    explicit Simulation(const Scene& scene);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// Advances by one time step. Allocates nothing unless neighbours are rebuilt.
    void step();

    double time() const;
    double time_step() const;    ///< of the fluid, or of solids if there is none [s]
    int solid_substeps() const;  ///< in each step; 1 = single-rate
    const std::vector<CourantLimit>& courant_limits() const;

    const Scene& scene() const;
    const Effects& effects() const;
    const ParticleSet<Dim>& fluid() const;
    const ParticleSet<Dim>& solid() const;
    const ParticleSet<Dim>& wall() const;
    const MaterialList& solid_materials() const;
    const PartRange& hyperelastic() const;  ///< range of solid(): the total-Lagrangian particles
    const ParticleSet<Dim>& interface() const;
    const ParticleSet<Dim>& boundary() const;

    WorkCount work() const;
    const PhaseTimer& timer() const;
    EnergyBalance energy() const;
    Vec<Dim> momentum() const;                          ///< of all moving particles [kg m/s]
    Vec<Dim> force_on(std::size_t body) const;          ///< of the fluid on a solid body [N; N/m in 2D]
    Vec<Dim> contact_force_on(std::size_t body) const;  ///< of contact, on a solid body [N; N/m in 2D]
    /// Finds fluid particles nearer than this many spacings to others, to fixed walls, or to solids that are their
    /// boundary.
    ClosestPair closest_pair(Neighbor to, double spacings, const CountsHere& counts = {}) const;
    /// Multiplies later steps by this share; 1 at the start.
    void set_step_share(double share);
    InterfaceBalance interface_balance() const;  ///< worst residual over all steps so far
    double max_mach() const;                     ///< highest |v|/c0 of the fluid so far
    double max_speed() const;                    ///< highest |v| of the fluid so far [m/s]
    std::size_t memory_bytes() const;            ///< particle fields and neighbour lists

    /// Writes everything that changes during a run. A simulation of the same scene that has restored it takes the same
    /// steps, to the bit, with any number of threads.
    void save(const StateWriter& writer) const;
    /// Throws CheckpointError for the state of another scene; the simulation cannot be used afterwards.
    void restore(const StateReader& reader);

    /// Hands the memory of a column over to the caller, and continues on a copy. Null if no column begins at this
    /// address.
    std::shared_ptr<const void> part_with(const void* column);

    /// Finds the index in solid() of a particle by its id.
    const IdIndex& solid_index_of_id() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

extern template class Simulation<2>;
extern template class Simulation<3>;

}  // namespace sluice
