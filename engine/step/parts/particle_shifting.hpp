// Particle shifting in a step (kernels/passes/shift_passes.hpp).
#pragma once

#include "engine/step/context.hpp"
#include "kernels/passes/shift_passes.hpp"

namespace sluice {

template <int Dim>
class ParticleShifting {
  public:
    /// Says what it pairs; before the neighbourhood is built.
    explicit ParticleShifting(StepContext<Dim>& context);

    /// Shifts the fluid's particles half-way through a step, every few steps by as much as in all of them. Returns the
    /// longest displacement. [m]
    double shift(std::uint64_t step);

    /// visit(name, member) for what changes during a run and is not among the particles' columns.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("last", last_), visit("next", next_);
    }

  private:
    /// What surrounds each particle: sums over fluid, walls and solids.
    void look_around();
    std::uint64_t interval_for(double path_over_h) const;

    StepContext<Dim>& c_;
    const NeighborList& fluid_;
    const NeighborList *at_walls_ = nullptr, *at_solids_ = nullptr, *at_solid_ghosts_ = nullptr;
    ShiftTerms terms_;
    std::uint64_t last_ = 0, next_ = 0;  ///< step after the last shift, and that of the next
};

extern template class ParticleShifting<2>;
extern template class ParticleShifting<3>;

}  // namespace sluice
