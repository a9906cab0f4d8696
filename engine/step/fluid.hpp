// The fluid's part of a step.
#pragma once

#include "engine/step/context.hpp"
#include "kernels/passes/density_passes.hpp"
#include "kernels/passes/fluid_passes.hpp"

namespace sluice {

template <int Dim>
class FluidPart {
  public:
    explicit FluidPart(StepContext<Dim>& context);

    /// acceleration = gravity and eq. (10).
    void forces();
    /// v += a · interval [s]. Notes the highest acceleration if steps adapt to it.
    void kick(double interval);
    /// Eq. (16), for as many steps of the single-rate scheme as the step replaces.
    void filter();
    /// x += v Δt/2, with the filter's correction of the velocity first, in one go through memory.
    void drift_halfway();
    /// dρ/dt of eq. (8) among the fluid, and density diffusion.
    void rates();
    /// x += v Δt/2, ρ += dρ/dt Δt, then the pressure. Returns how far particles have moved in the step. [m]
    double finish();

    double max_speed() const { return max_speed_; }        ///< highest |v| so far [m/s]
    double speed() const { return speed_; }                ///< highest |v| of the last step [m/s]
    double acceleration() const { return acceleration_; }  ///< highest |a| of the last kick [m/s²]

    /// visit(name, member) for what changes during a run and is not among the particles' columns.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("max_speed", max_speed_), visit("speed", speed_), visit("acceleration", acceleration_);
    }

  private:
    StepContext<Dim>& c_;
    FluidTerms terms_;
    DiffusionTerms<Dim> diffusion_;
    double acoustic_damping_ = 0;  ///< α
    double max_speed_ = 0, speed_ = 0, acceleration_ = 0;
};

extern template class FluidPart<2>;
extern template class FluidPart<3>;

}  // namespace sluice
