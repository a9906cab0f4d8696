// Particle shifting in a step (kernels/passes/shift_passes.hpp).
#pragma once

#include "engine/step/context.hpp"
#include "kernels/passes/shift_passes.hpp"

namespace sluice {

template <int Dim>
class ParticleShifting {
  public:
    /// Asks for its pairings; construct before the neighbourhood is built.
    explicit ParticleShifting(StepContext<Dim>& context);

    /// Shifts the fluid's particles half-way through a step, once in a few steps by as much as all of them call for.
    /// Returns the longest displacement. [m]
    double shift(std::uint64_t step);

    /// visit(name, member) for what changes during a run and is not in the particles' columns.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("last", last_), visit("next", next_);
    }

  private:
    /// Sums over each particle's neighbours among fluid, walls and solids.
    void look_around();
    std::uint64_t interval_for(double path_over_h) const;

    StepContext<Dim>& c_;
    const NeighborList& fluid_;
    const NeighborList *at_walls_ = nullptr, *at_solids_ = nullptr, *at_solid_ghosts_ = nullptr;
    ShiftTerms terms_;
    std::uint64_t last_ = 0, next_ = 0;  ///< the step after the last shift, and the step of the next
};

extern template class ParticleShifting<2>;
extern template class ParticleShifting<3>;

}  // namespace sluice
