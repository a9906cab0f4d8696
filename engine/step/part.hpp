// The parts that a step advances: the fluid, solids of each model, walls.
#pragma once

#include <vector>

#include "engine/step/energy_balance.hpp"
#include "engine/step/step_plan.hpp"
#include "neighbor/vec.hpp"

namespace sluice {

class StateReader;
class StateWriter;

/// The stages of a step, in order; each is called for all parts before the next. A part does nothing in a stage that it
/// does not override. Virtual calls are made once per stage, never per pair.
template <int Dim>
class Part {
  public:
    virtual ~Part() = default;
    Part() = default;
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

    /// Called once, when particles have been sorted and listed for the first time.
    virtual void start() {}
    /// Adds the largest stable step of each of its materials.
    virtual void limit_step(std::vector<CourantLimit>&) const {}

    /// Advances from time n to the middle of the step; solids, which have steps of their own, take all of them.
    virtual void first_half() {}
    /// Computes rates of density, at half-way positions.
    virtual void rates() {}
    /// Advances from the middle of the step to its end.
    virtual void second_half() {}
    /// Computes accelerations at the end of the step.
    virtual void forces() {}
    /// Brings velocities to where they stand between steps.
    virtual void last_kick() {}

    virtual void add_energy(EnergyBalance&) const {}
    virtual Vec<Dim> momentum() const { return {}; }  ///< [kg m/s]

    /// Writes and reads what changes during a run and is not in the particles' columns.
    virtual void save(const StateWriter&) {}
    virtual void restore(const StateReader&) {}
};

}  // namespace sluice
