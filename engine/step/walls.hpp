// The rigid walls' part of a step: layers of fixed ghosts, whose pressure is taken from the fluid in front of them.
#pragma once

#include "engine/step/context.hpp"

namespace sluice {

template <int Dim>
class WallPart {
  public:
    explicit WallPart(StepContext<Dim>& context) : c_(context) {}

    /// The ghosts' pressure, and what it does to the fluid.
    void forces();
    /// Their share of the fluid's dρ/dt.
    void rates();

  private:
    StepContext<Dim>& c_;
};

extern template class WallPart<2>;
extern template class WallPart<3>;

}  // namespace sluice
