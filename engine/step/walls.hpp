// The rigid walls' part of a step: layers of ghosts, whose pressure is taken from the fluid in front of them.
#pragma once

#include <optional>
#include <vector>

#include "engine/step/context.hpp"
#include "engine/step/wall_motion.hpp"
#include "kernels/pairs/block_totals.hpp"

namespace sluice {

template <int Dim>
class WallPart {
  public:
    explicit WallPart(StepContext<Dim>& context);

    /// Walls go to the middle of the step from t to t + Δt, with their mean velocity over it. Returns how far a wall
    /// moves in the step at the most. [m]
    double move_halfway(double t);
    /// Walls go to the end of the step, the time t.
    void finish(double t);
    /// The ghosts' pressure, and what it does to the fluid.
    void forces();
    /// Their share of the fluid's dρ/dt.
    void rates();

    /// visit(name, member) for what changes during a run and is not among the particles' columns.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("displacement", displacement_), visit("velocity", velocity_), visit("acceleration", acceleration_);
    }

  private:
    void friction();
    /// Ghosts stand where their walls have moved to, and move with them.
    void place();

    StepContext<Dim>& c_;
    std::vector<std::optional<WallMotion<Dim>>> motion_;  ///< by the walls' numbers; empty if none moves
    std::vector<Vec<Dim>> displacement_, velocity_, acceleration_, effective_gravity_;
    BlockTotals<Dim> block_totals_;
};

extern template class WallPart<2>;
extern template class WallPart<3>;

}  // namespace sluice
