// What each thread did when, of a few steps of a run: the raw material of trace.json.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "neighbor/loop_watch.hpp"

namespace sluice {

/// Of a run that may be asked for.
inline constexpr int most_traced_steps = 1000;

/// Which steps are traced: so many, evenly spaced in simulated time.
struct TracePlan {
    int steps = 0;
    double begin = 0, end = 0;  ///< simulated time [s]
};

class TraceRecorder {
  public:
    /// What a stretch of time was: a section of the step, the first thread's share of its loop, or its waiting for the
    /// others.
    enum class Kind : std::uint32_t { section, share, wait };
    struct Event {
        Kind kind;
        std::uint32_t entry;  ///< of the profile
        Nanoseconds begin, end;
    };
    struct Step {
        std::uint64_t number;
        double time;             ///< simulated, before the step [s]
        Nanoseconds begin, end;  ///< of the clock
    };
    /// Of each thread; some 5 MB of text.
    static constexpr std::size_t most_events = 50'000;

    TraceRecorder(int threads, const TracePlan& plan);

    /// Returns whether this step is traced: if it is due, and the last traced step would have found room again.
    bool begin_step(std::uint64_t number, double time, Nanoseconds at);
    void end_step(Nanoseconds at);
    /// By the thread itself. What finds no room is left out.
    void add(int thread, const Event& event);

    const std::vector<Step>& steps() const { return steps_; }
    const std::vector<Event>& events(int thread) const { return lanes_[static_cast<std::size_t>(thread)].events; }
    int threads() const { return static_cast<int>(lanes_.size()); }
    /// Whether steps that were due, or parts of them, found no room.
    bool is_cut() const;

  private:
    struct alignas(64) Lane {
        std::vector<Event> events;
        std::size_t before_step = 0, most_in_step = 0;
        bool cut = false;
    };
    TracePlan plan_;
    std::vector<Lane> lanes_;
    std::vector<Step> steps_;
    int due_ = 0;  ///< steps that were, so far
    bool full_ = false;
};

}  // namespace sluice
