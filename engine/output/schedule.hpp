// When an output is due.
#pragma once

namespace sluice {

/// Output at 0, interval, 2·interval …, each at the first step that is at most half a step early.
class Schedule {
  public:
    /// [s]; 0 = never.
    explicit Schedule(double interval) : interval_(interval) {}

    enum class Answer { wait, due };
    /// Asked once after each step of length `dt`; what is due counts as done.
    Answer ask(double time, double dt);

  private:
    double interval_;
    double next_ = 0;  ///< multiple of the interval that is due next; a double holds it exactly
};

}  // namespace sluice
