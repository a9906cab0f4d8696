// Couples fluid and solid as in the paper, by a pressure on the elements of their interface
// (kernels/passes/interface_passes.hpp).
#pragma once

#include "engine/step/context.hpp"
#include "engine/step/coupling.hpp"
#include "kernels/passes/interface_passes.hpp"

namespace sluice {

template <int Dim>
class InterfaceCoupling final : public Coupling<Dim> {
  public:
    explicit InterfaceCoupling(StepContext<Dim>& context);

    /// Computes the pressure on the elements, the force on the solid and the reaction on the fluid.
    void forces() override;
    /// Adds the interface's share of the fluid's dρ/dt, from the solid's mean motion over the step.
    void rates() override;
    const InterfaceBalance* balance() const override { return &balance_; }
    Vec<Dim> fluid_force_on(std::size_t body) const override;
    void save(const StateWriter& writer) override;
    void restore(const StateReader& reader) override;

  private:
    const NeighborList& elements_with(SetId particles, Targets targets);
    const NeighborList& with_elements(SetId particles, Targets targets);
    /// Moves elements with the solid: position and area from its outer particles, velocity with the weights of the
    /// forces.
    void update_elements(const VectorField<Dim>& solid_position, const ParticleView<Dim>& solid);
    /// Applies the force on the solid, and returns its sum.
    Vec<Dim> force_solid();
    void record_balance(const Vec<Dim>& on_solid, const Vec<Dim>& on_fluid);

    StepContext<Dim>& c_;
    // Particles near elements, and elements near particles; ghosts in lists of their own.
    const NeighborList &fluid_at_elements_, &fluid_ghosts_at_elements_, &solid_at_elements_;
    const NeighborList &elements_at_fluid_, &element_ghosts_at_fluid_, &elements_at_solid_;
    BlockTotals<Dim> block_totals_;
    InterfaceBalance balance_;
};

extern template class InterfaceCoupling<2>;
extern template class InterfaceCoupling<3>;

}  // namespace sluice
