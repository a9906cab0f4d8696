// States in memory that a run can go back to, and how short its steps are after it has.
#pragma once

#include <cstdint>
#include <deque>

#include "engine/run/checkpoint/checkpoint_file.hpp"

namespace sluice {

class Recovery {
  public:
    /// A good state of this step. The last two are kept.
    void keep(std::uint64_t step, CheckpointImage image) {
        state_.push_back({step, std::move(image)});
        if (state_.size() > 2) state_.pop_front();
    }
    /// Every thousand steps: a state costs about a step.
    bool due(std::uint64_t step) const { return state_.empty() || step % interval == 0; }

    struct Good {
        std::uint64_t step;
        CheckpointImage image;
    };
    /// The state to go back to after a breakdown: not one just before it, in which the cause may have been already.
    Good& before(std::uint64_t step) {
        Good& last = state_.back();
        return last.step + safe_distance <= step ? last : state_.front();
    }
    bool empty() const { return state_.empty(); }

    /// Halves the share of the step, until some time after the breakdown. False if it is too short already.
    bool shorten(std::uint64_t broken_step) {
        if (share_ <= least_share) return false;
        share_ /= 2;
        calm_step_ = broken_step + interval;
        return true;
    }
    /// Whether the full step may be tried again at this step.
    bool calm(std::uint64_t step) {
        if (share_ == 1 || step < calm_step_) return false;
        share_ = 1;
        return true;
    }

    struct Shortening {
        double share;
        std::uint64_t calm_step;
    };
    Shortening shortening() const { return {share_, calm_step_}; }
    void set(const Shortening& s) { share_ = s.share, calm_step_ = s.calm_step; }

    /// visit(name, member) for what changes during a run, but for the states themselves.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("share", share_), visit("calm_step", calm_step_);
    }

  private:
    static constexpr std::uint64_t interval = 1000, safe_distance = 200;  ///< [steps]
    static constexpr double least_share = 1.0 / 64;

    std::deque<Good> state_;
    double share_ = 1;  ///< of the step that it would be
    std::uint64_t calm_step_ = 0;
};

}  // namespace sluice
