// Wall time per phase of a step.
#pragma once

#include <array>
#include <chrono>

#include "engine/scene/effects/step_phase.hpp"
#include "neighbor/loop_watch.hpp"

namespace sluice {

/// The section that profiles know a phase by.
inline const Section& section_of(StepPhase phase) {
    static constexpr auto sections = [] {
        std::array<Section, step_phase_names.size()> all;
        for (std::size_t k = 0; k < all.size(); ++k) all[k].name = step_phase_names[k];
        return all;
    }();
    return sections[static_cast<std::size_t>(phase)];
}

class PhaseTimer {
  public:
    /// Adds its lifetime to a phase.
    class Scope {
      public:
        Scope(PhaseTimer& t, StepPhase p) : timer_(t), phase_(p), watched_(section_of(p)), start_(Clock::now()) {}
        ~Scope() {
            timer_.seconds_[static_cast<std::size_t>(phase_)] +=
                std::chrono::duration<double>(Clock::now() - start_).count();
        }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        PhaseTimer& timer_;
        StepPhase phase_;
        WatchedSection watched_;
        std::chrono::steady_clock::time_point start_;
    };
    Scope measure(StepPhase p) { return Scope(*this, p); }
    const std::array<double, step_phase_names.size()>& seconds() const { return seconds_; }

    /// visit(name, member) for what changes during a run.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("seconds", seconds_);
    }

  private:
    using Clock = std::chrono::steady_clock;
    std::array<double, step_phase_names.size()> seconds_{};
};

}  // namespace sluice
