// Fluid at rigid walls: the walls' particles push with a pressure that is taken from the fluid in front of them.
#pragma once

#include <vector>

#include "engine/step/context.hpp"
#include "engine/step/coupling.hpp"
#include "kernels/pairs/block_totals.hpp"

namespace sluice {

template <int Dim>
class WallCoupling final : public Coupling<Dim> {
  public:
    explicit WallCoupling(StepContext<Dim>& context);

    /// The walls' share of the fluid's dρ/dt.
    void rates() override;
    /// The walls' pressure, and what it does to the fluid.
    void forces() override;

  private:
    void friction();

    StepContext<Dim>& c_;
    const NeighborList &of_fluid_, &of_walls_;  ///< walls near the fluid's particles; fluid near the walls'
    std::vector<Vec<Dim>> effective_gravity_;   ///< by the walls' numbers
    BlockTotals<Dim> block_totals_;
};

extern template class WallCoupling<2>;
extern template class WallCoupling<3>;

}  // namespace sluice
