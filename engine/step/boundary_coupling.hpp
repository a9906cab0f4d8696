// The coupling of fluid and solid in which the solid's particles are the fluid's moving boundary
// (kernels/terms/moving_boundary.hpp).
#pragma once

#include "engine/scene/light_solid.hpp"
#include "engine/step/context.hpp"
#include "engine/step/interface_balance.hpp"
#include "kernels/passes/boundary_passes.hpp"

namespace sluice {

template <int Dim>
class BoundaryCoupling {
  public:
    explicit BoundaryCoupling(StepContext<Dim>& context)
        : c_(context), relaxation_(light_solid(context.scene).relaxation) {}

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
    /// Copies place and velocity of the solid's particles, and shows them to the images.
    void follow(const VectorField<Dim>& position, const VectorField<Dim>& velocity);
    /// Copies the solid's mean acceleration; that of a light solid is approached (engine/scene/light_solid.hpp).
    void follow_acceleration();
    /// What a viscous fluid's friction adds to both sides; the sums of the forces on solid and fluid.
    void friction(Vec<Dim>& on_solid, Vec<Dim>& on_fluid);
    void hand_over();
    void record_balance(const Vec<Dim>& on_solid, const Vec<Dim>& on_fluid);

    StepContext<Dim>& c_;
    double relaxation_;  ///< β of engine/scene/light_solid.hpp
    BlockTotals<Dim> block_totals_;
    InterfaceBalance balance_;
};

extern template class BoundaryCoupling<2>;
extern template class BoundaryCoupling<3>;

}  // namespace sluice
