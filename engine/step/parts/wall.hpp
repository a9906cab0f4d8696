// The motion of rigid walls made of layers of particles.
#pragma once

#include <optional>
#include <vector>

#include "engine/step/context.hpp"
#include "engine/step/part.hpp"
#include "engine/step/parts/wall_motion.hpp"

namespace sluice {

/// The walls of a scene in which at least one moves. How walls act on fluid and solids is up to couplings.
template <int Dim>
class WallPart final : public Part<Dim> {
  public:
    explicit WallPart(StepContext<Dim>& context);

    void start() override;
    /// Moves walls to the middle of the step, with their mean velocity over it.
    void first_half() override;
    /// Moves walls to the end of the step.
    void second_half() override;
    void save(const StateWriter& writer) override;
    void restore(const StateReader& reader) override;

  private:
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("wall_displacement", displacement_), visit("wall_velocity", velocity_);
        visit("wall_acceleration", c_.wall_acceleration);
    }
    void finish(double t);
    /// Gives particles the positions and velocities of their walls.
    void place();

    StepContext<Dim>& c_;
    std::vector<std::optional<WallMotion<Dim>>> motion_;  ///< by the walls' numbers
    std::vector<Vec<Dim>> displacement_, velocity_;
};

extern template class WallPart<2>;
extern template class WallPart<3>;

}  // namespace sluice
