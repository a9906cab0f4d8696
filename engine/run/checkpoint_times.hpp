// When a checkpoint is due.
#pragma once

#include <algorithm>

#include "engine/base/wall_clock.hpp"
#include "engine/run/schedule.hpp"
#include "engine/scene/scene.hpp"

namespace sluice {

/// At multiples of a simulated time, and whenever some wall time has passed since the last one. When checkpoints are
/// written changes nothing in the results, so the clock may have a say.
class CheckpointTimes {
  public:
    explicit CheckpointTimes(const OutputTimes& output)
        : simulated_(output.checkpoint_interval), wall_(60 * output.checkpoint_minutes), last_(WallClock::now()) {}

    /// Asked once after each step of length `dt`. [s]
    bool due(double time, double dt) {
        const bool by_time = simulated_.ask(time, dt) == Schedule::Answer::due;
        return by_time || (wall_ > 0 && seconds_since(last_) >= std::max(wall_, least_ratio * cost_));
    }
    /// Tells that one was written, and how long it took. [s]
    void was_written(double cost) {
        cost_ = cost;
        last_ = WallClock::now();
    }

    /// visit(name, member) for what changes during a run, but for the clock.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("simulated", simulated_);
    }

  private:
    /// Onto a slow disk less often, so that no more than a hundredth of the time goes there.
    static constexpr double least_ratio = 100;

    Schedule simulated_;
    double wall_;  ///< [s]
    double cost_ = 0;
    WallClock::time_point last_;
};

}  // namespace sluice
