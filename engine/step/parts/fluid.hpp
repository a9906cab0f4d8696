// The fluid as a part of a step.
#pragma once

#include <vector>

#include "engine/step/context.hpp"
#include "engine/step/part.hpp"
#include "engine/step/parts/particle_shifting.hpp"
#include "kernels/passes/density_passes.hpp"
#include "kernels/passes/fluid_passes.hpp"

namespace sluice {

template <int Dim>
class FluidPart final : public Part<Dim> {
  public:
    explicit FluidPart(StepContext<Dim>& context);

    void start() override;
    void limit_step(std::vector<CourantLimit>& limits) const override;
    /// v += a over the first part of the step, the velocity filter, x += v Δt/2.
    void first_half() override;
    /// dρ/dt of eq. (8) among the fluid, and density diffusion.
    void rates() override;
    /// Particle shifting; x += v Δt/2, ρ += dρ/dt Δt, then the pressure.
    void second_half() override;
    /// acceleration = gravity and eq. (10).
    void forces() override;
    /// Kick-drift-kick: v += a Δt/2.
    void last_kick() override;
    void add_energy(EnergyBalance& e) const override;
    Vec<Dim> momentum() const override;
    void save(const StateWriter& writer) override;
    void restore(const StateReader& reader) override;

  private:
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("max_speed", c_.flow.highest), visit("speed", c_.flow.now), visit("acceleration", c_.flow.acceleration);
        visit("shifting", shifting_), visit("last_dt", last_dt_);
    }
    /// v += a · interval [s]. Records the highest acceleration if steps adapt to it.
    void kick(double interval);
    /// Eq. (16), as often as the single-rate steps that this step replaces would apply it.
    void filter();
    /// Adds the filter's correction to v, then x += v Δt/2, in one pass through memory.
    void drift_halfway();
    /// The density less its hydrostatic part, which Fourtakas' diffusion evens out.
    void update_excess_density();
    /// Computes p and p/ρ² from the density.
    void update_pressure();
    /// x += v Δt/2, ρ += dρ/dt Δt, then p and p/ρ². With acoustic damping α the pressure has the part of a bulk
    /// viscosity ζ = α ρ c0 h [Sun et al. 2023], −ζ ∇·v = α c0 h dρ/dt: sound decays at the rate α c0 h k²/2, shear
    /// does not, and no pass over pairs is needed. A particle that slipped through a mirror plane changes places with
    /// its ghost, which has the same state. Returns the highest speed [m/s]; NaN if a velocity is not finite.
    double drift_to_end();

    StepContext<Dim>& c_;
    const NeighborList& list_;
    ParticleShifting<Dim> shifting_;
    FluidTerms terms_;
    DiffusionTerms<Dim> diffusion_;
    double acoustic_damping_ = 0;  ///< α
    double last_dt_ = 0;           ///< of the previous step [s]
};

extern template class FluidPart<2>;
extern template class FluidPart<3>;

}  // namespace sluice
