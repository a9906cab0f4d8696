// Couples fluid and solid with the solid's particles as the fluid's moving boundary
// (kernels/terms/moving_boundary.hpp).
#pragma once

#include "engine/scene/light_solid.hpp"
#include "engine/step/context.hpp"
#include "engine/step/coupling.hpp"
#include "kernels/passes/boundary_passes.hpp"

namespace sluice {

template <int Dim>
class BoundaryCoupling final : public Coupling<Dim> {
  public:
    explicit BoundaryCoupling(StepContext<Dim>& context);

    /// Computes the fluid's pressure on the boundary and the reaction.
    void forces() override;
    /// Adds the boundary's share of the fluid's dρ/dt, from the solid's mean motion over the step.
    void rates() override;
    const InterfaceBalance* balance() const override { return &balance_; }
    Vec<Dim> fluid_force_on(std::size_t body) const override;
    void save(const StateWriter& writer) override;
    void restore(const StateReader& reader) override;

  private:
    const NeighborList& list(SetId query, SetId target, Targets targets);
    /// Adds the pairs of passes over these lists to the count.
    void count_pairs(std::initializer_list<const NeighborList*> lists);
    /// Copies position and velocity of the solid's particles to the boundary and its ghosts.
    void follow(const VectorField<Dim>& position, const VectorField<Dim>& velocity);
    /// Copies the solid's mean acceleration, under-relaxed if the solid is light (engine/scene/light_solid.hpp).
    void follow_acceleration();
    /// Adds a viscous fluid's friction to both sides, and to the sums of the forces on solid and fluid.
    void friction(Vec<Dim>& on_solid, Vec<Dim>& on_fluid);
    void hand_over();
    void record_balance(const Vec<Dim>& on_solid, const Vec<Dim>& on_fluid);

    StepContext<Dim>& c_;
    const NeighborList &of_fluid_, &ghosts_of_fluid_;        ///< boundary particles near fluid particles
    const NeighborList &of_boundary_, &ghosts_of_boundary_;  ///< fluid particles near boundary particles
    std::vector<double> relaxation_;  ///< β of engine/scene/light_solid.hpp, of each of the scene's bodies
    bool relaxes_ = false;            ///< β < 1 for one of them
    BlockTotals<Dim> block_totals_;
    InterfaceBalance balance_;
};

extern template class BoundaryCoupling<2>;
extern template class BoundaryCoupling<3>;

}  // namespace sluice
