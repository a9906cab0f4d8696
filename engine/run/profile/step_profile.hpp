// Where the time of steps goes: sections and loops, each with the time that each thread worked in it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/run/profile/trace_recorder.hpp"
#include "neighbor/loop_watch.hpp"

namespace sluice {

/// How often the system has taken a processor from one of this program's threads.
long interruptions();

class StepProfile final : public LoopWatch {
  public:
    /// One kind of section at one place in the step, summed over all its calls.
    struct Entry {
        const Section* section = nullptr;  ///< null: the step as a whole
        std::size_t parent = 0;            ///< always in front of the entry itself
        std::uint64_t calls = 0;
        Nanoseconds wall = 0;  ///< with all that is entered from it
        PairWork work;
        std::vector<Nanoseconds> busy;  ///< of each thread, with all that is entered from it
    };

    explicit StepProfile(int threads, const TracePlan& plan = {});

    /// What is run until it ends is a step, and watched.
    class Step {
      public:
        /// `profile`: null = nobody asks.
        Step(StepProfile* profile, std::uint64_t number, double time) : profile_(profile) {
            if (profile_) profile_->begin_step(number, time);
        }
        ~Step() {
            if (profile_) profile_->end_step();
        }
        Step(const Step&) = delete;
        Step& operator=(const Step&) = delete;

      private:
        StepProfile* profile_;
    };

    void enter(const Section& section) override;
    void leave(const PairWork& work) override;
    void worked(int thread, Nanoseconds begin, Nanoseconds end) override;
    void joined(Nanoseconds at) override;

    int threads() const { return static_cast<int>(lanes_.size()); }
    std::uint64_t steps() const { return places_.front().calls; }
    /// Since this was made.
    long interrupted() const { return interruptions() - interruptions_before_; }
    /// The step first, then what is in it; busy times filled in.
    std::vector<Entry> entries() const;
    const TraceRecorder& trace() const { return trace_; }

  private:
    /// An entry while it is being added to.
    struct Place {
        const Section* section = nullptr;
        std::size_t parent = 0;
        std::vector<std::size_t> inside;
        std::uint64_t calls = 0;
        Nanoseconds wall = 0, waited = 0, entered = 0;  ///< waited: by the first thread, at the ends of its own loops
        PairWork work;
    };
    /// Of one thread, away from the others' cache lines.
    struct alignas(64) Lane {
        std::vector<Nanoseconds> busy;  ///< by place: in its own loops
    };

    void begin_step(std::uint64_t number, double time);
    void end_step();
    std::size_t add_place(const Section* section, std::size_t parent);

    std::vector<Place> places_;
    std::vector<Lane> lanes_;
    TraceRecorder trace_;
    long interruptions_before_ = interruptions();
    std::size_t current_ = 0;
    Nanoseconds share_end_ = 0;  ///< of the first thread's share of the loop in hand
    Nanoseconds joined_at_ = 0;
    bool tracing_ = false;
};

}  // namespace sluice
