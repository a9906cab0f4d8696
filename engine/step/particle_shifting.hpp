// Particle shifting in a step (kernels/shift_passes.hpp).
#pragma once

#include "engine/step/context.hpp"

namespace sluice {

template <int Dim>
class ParticleShifting {
  public:
    explicit ParticleShifting(StepContext<Dim>& context);

    /// Shifts the fluid's particles half-way through a step, every few steps by as much as in all of them. Returns the
    /// longest displacement. [m]
    double find(std::uint64_t step);

  private:
    /// What surrounds each particle: sums over fluid, walls and solids.
    void look_around();

    StepContext<Dim>& c_;
    ShiftTerms terms_;
};

extern template class ParticleShifting<2>;
extern template class ParticleShifting<3>;

}  // namespace sluice
