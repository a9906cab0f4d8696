// The paper's coupling of fluid and solid: a pressure on the elements of their interface
// (kernels/passes/interface_passes.hpp).
#pragma once

#include "engine/step/context.hpp"
#include "engine/step/interface_balance.hpp"
#include "kernels/passes/interface_passes.hpp"

namespace sluice {

template <int Dim>
class InterfaceCoupling {
  public:
    explicit InterfaceCoupling(StepContext<Dim>& context) : c_(context) {}

    /// Pressure on the elements, the force on the solid and the reaction on the fluid.
    void forces();
    /// The interface's share of the fluid's dρ/dt, from the solid's mean motion over the step.
    void rates();
    const InterfaceBalance& balance() const { return balance_; }

    /// visit(name, member) for what changes during a run and is not among the particles' columns.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("balance", balance_);
    }

  private:
    /// Elements follow the solid: place and area from the boundary particles, velocity from the weights of its forces.
    void update_elements(const VectorField<Dim>& solid_position, const ParticleView<Dim>& solid);
    /// Returns the whole force on the solid.
    Vec<Dim> push_solid();
    void record_balance(const Vec<Dim>& on_solid, const Vec<Dim>& on_fluid);

    StepContext<Dim>& c_;
    BlockTotals<Dim> block_totals_;
    InterfaceBalance balance_;
};

extern template class InterfaceCoupling<2>;
extern template class InterfaceCoupling<3>;

}  // namespace sluice
