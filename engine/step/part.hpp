// What a step does with each part of a scene: the fluid, solids of each model, walls.
#pragma once

#include <vector>

#include "engine/step/energy_balance.hpp"
#include "engine/step/step_plan.hpp"
#include "neighbor/vec.hpp"

namespace sluice {

class StateReader;
class StateWriter;

/// The stages of a step, in their order; each is called for all parts before the next. A part does nothing in those that
/// it leaves out. Choices are made here, once per stage, and never per pair.
template <int Dim>
class Part {
  public:
    virtual ~Part() = default;
    Part() = default;
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

    /// Once, when particles are sorted and listed for the first time.
    virtual void start() {}
    /// Tells the largest steps that it bears.
    virtual void limit_step(std::vector<CourantLimit>&) const {}

    /// From time n to the middle of the step; what has steps of its own goes through all of them.
    virtual void first_half() {}
    /// Rates of density, at half-way positions.
    virtual void rates() {}
    /// From the middle of the step to its end.
    virtual void second_half() {}
    /// Accelerations at the end of the step.
    virtual void forces() {}
    /// Brings velocities to where they stand between steps.
    virtual void last_kick() {}

    virtual void add_energy(EnergyBalance&) const {}
    virtual Vec<Dim> momentum() const { return {}; }  ///< [kg m/s]

    /// What changes during a run and is not among the particles' columns.
    virtual void save(const StateWriter&) {}
    virtual void restore(const StateReader&) {}
};

}  // namespace sluice
