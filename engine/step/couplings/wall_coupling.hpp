// Couples fluid and rigid walls: wall particles push with a pressure extrapolated from the fluid in front of them.
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

    /// Adds the walls' share of the fluid's dρ/dt.
    void rates() override;
    /// Computes the walls' pressure and its force on the fluid.
    void forces() override;

  private:
    void friction();

    StepContext<Dim>& c_;
    const NeighborList &of_fluid_, &of_walls_;  ///< wall particles near fluid particles, and the reverse
    std::vector<Vec<Dim>> effective_gravity_;   ///< by the walls' numbers
    BlockTotals<Dim> block_totals_;
};

extern template class WallCoupling<2>;
extern template class WallCoupling<3>;

}  // namespace sluice
