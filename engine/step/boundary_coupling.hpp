// The coupling of fluid and solid in which the solid's particles are the fluid's moving boundary
// (kernels/terms/moving_boundary.hpp).
#pragma once

#include "engine/step/context.hpp"
#include "engine/step/interface_balance.hpp"
#include "kernels/boundary_passes.hpp"

namespace sluice {

template <int Dim>
class BoundaryCoupling {
  public:
    explicit BoundaryCoupling(StepContext<Dim>& context) : c_(context) {}

    /// The fluid's pressure on the boundary and the reaction.
    void forces();
    /// The boundary's share of the fluid's dρ/dt, from the solid's mean motion over the step.
    void rates();
    const InterfaceBalance& balance() const { return balance_; }

    /// visit(name, member) for what changes during a run and is not among the particles' columns.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("balance", balance_);
    }

  private:
    /// Copies place, velocity and acceleration of the solid's particles.
    void follow(const VectorField<Dim>& position, const VectorField<Dim>& velocity);
    /// What a viscous fluid's friction adds to both sides; the sums of the forces on solid and fluid.
    void friction(Vec<Dim>& on_solid, Vec<Dim>& on_fluid);
    void hand_over();
    void record_balance(const Vec<Dim>& on_solid, const Vec<Dim>& on_fluid);

    StepContext<Dim>& c_;
    BlockTotals<Dim> block_totals_;
    InterfaceBalance balance_;
};

extern template class BoundaryCoupling<2>;
extern template class BoundaryCoupling<3>;

}  // namespace sluice
