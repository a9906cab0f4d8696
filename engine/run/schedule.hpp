// When an output is due.
#pragma once

#include <cmath>

namespace sluice {

/// Output at 0, interval, 2·interval …, each at the first step that is at most half a step early.
class Schedule {
  public:
    /// [s]; 0 = never.
    explicit Schedule(double interval) : interval_(interval) {}

    enum class Answer { wait, due };
    /// Asked once after each step of length `dt`; what is due counts as done.
    Answer ask(double time, double dt);

    /// visit(name, member) for what changes during a run.
    template <class Visit>
    void visit_state(Visit&& visit) {
        double interval = interval_;
        visit("interval", interval), visit("next", next_);
        if (interval != interval_) next_ = std::ceil(next_ * interval / interval_);  // the same time, or the next
    }

  private:
    double interval_;
    double next_ = 0;  ///< multiple of the interval that is due next; a double holds it exactly
};

}  // namespace sluice
