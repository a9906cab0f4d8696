// The coupling of fluid and solid in which the solid's particles are the fluid's moving boundary
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

    /// The fluid's pressure on the boundary and the reaction.
    void forces() override;
    /// The boundary's share of the fluid's dρ/dt, from the solid's mean motion over the step.
    void rates() override;
    const InterfaceBalance* balance() const override { return &balance_; }
    Vec<Dim> fluid_force_on(std::size_t body) const override;
    void save(const StateWriter& writer) override;
    void restore(const StateReader& reader) override;

  private:
    const NeighborList& list(SetId query, SetId target, Targets targets);
    /// Counts the pairs of passes over these lists.
    void count_pairs(std::initializer_list<const NeighborList*> lists);
    /// Copies place and velocity of the solid's particles, and shows them to the images.
    void follow(const VectorField<Dim>& position, const VectorField<Dim>& velocity);
    /// Copies the solid's mean acceleration; that of a light solid is approached (engine/scene/light_solid.hpp).
    void follow_acceleration();
    /// What a viscous fluid's friction adds to both sides; the sums of the forces on solid and fluid.
    void friction(Vec<Dim>& on_solid, Vec<Dim>& on_fluid);
    void hand_over();
    void record_balance(const Vec<Dim>& on_solid, const Vec<Dim>& on_fluid);

    StepContext<Dim>& c_;
    const NeighborList &of_fluid_, &ghosts_of_fluid_;        ///< boundary near the fluid's particles
    const NeighborList &of_boundary_, &ghosts_of_boundary_;  ///< fluid near the boundary's
    std::vector<double> relaxation_;  ///< β of engine/scene/light_solid.hpp, of each of the scene's bodies
    bool relaxes_ = false;            ///< β < 1 for one of them
    BlockTotals<Dim> block_totals_;
    InterfaceBalance balance_;
};

extern template class BoundaryCoupling<2>;
extern template class BoundaryCoupling<3>;

}  // namespace sluice
