// What threads do in the sections of a step, told to whoever watches: where profiles come from. Nobody watches as a
// rule; a section then costs the look at one pointer, and no clock is read.
#pragma once

#include <omp.h>

#include <chrono>
#include <cstdint>
#include <string_view>

namespace sluice {

/// Of the steady clock [ns].
using Nanoseconds = std::int64_t;
inline Nanoseconds clock_now() {
    using namespace std::chrono;
    return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

/// A kind of work, known by its address: a phase of a step, or one loop over pairs.
struct Section {
    std::string_view name;
    int number_bytes = 0;  ///< of a loop over pairs: of the numbers that it computes with; 0 = no loop
    double (*operations_per_lane)() = nullptr;  ///< of a loop over pairs (kernels/pairs/operation_count.hpp)
};

/// What a loop over pairs had to do.
struct PairWork {
    std::uint64_t particles = 0;                     ///< that it sums for
    std::uint64_t pairs = 0;                         ///< directed pairs inside the support, when the list was built
    std::uint64_t lanes = 0;                         ///< pairs gone over, those outside the support too
    std::uint64_t list_bytes = 0, column_bytes = 0;  ///< read and written, if each is moved once

    PairWork& operator+=(const PairWork& w) {
        particles += w.particles, pairs += w.pairs, lanes += w.lanes;
        list_bytes += w.list_bytes, column_bytes += w.column_bytes;
        return *this;
    }
};

/// All but worked() is called by the thread that takes the steps.
class LoopWatch {
  public:
    virtual ~LoopWatch() = default;
    /// Sections are left in the reverse order in which they were entered.
    virtual void enter(const Section& section) = 0;
    virtual void leave(const PairWork& work) = 0;
    /// A thread of a team has done its share of a loop; called by that thread.
    virtual void worked(int thread, Nanoseconds begin, Nanoseconds end) = 0;
    /// The team's threads have waited for each other.
    virtual void joined(Nanoseconds at) = 0;
};

/// Who watches this thread's steps; null = nobody.
inline constinit thread_local LoopWatch* loop_watch = nullptr;

/// A section as a lifetime.
class WatchedSection {
  public:
    explicit WatchedSection(const Section& section) : watch_(loop_watch) {
        if (watch_) watch_->enter(section);
    }
    ~WatchedSection() {
        if (watch_) watch_->leave(work_);
    }
    WatchedSection(const WatchedSection&) = delete;
    WatchedSection& operator=(const WatchedSection&) = delete;

    bool is_watched() const { return watch_ != nullptr; }
    void set_work(const PairWork& work) { work_ = work; }

  private:
    LoopWatch* watch_;
    PairWork work_;
};

/// A parallel loop as a lifetime, on the thread that starts it: it ends when the team has come together again.
class WatchedLoop {
  public:
    WatchedLoop() : watch_(loop_watch) {}
    ~WatchedLoop() {
        if (watch_) watch_->joined(clock_now());
    }
    WatchedLoop(const WatchedLoop&) = delete;
    WatchedLoop& operator=(const WatchedLoop&) = delete;

    LoopWatch* watch() const { return watch_; }

  private:
    LoopWatch* watch_;
};

/// A thread's share of a parallel loop as a lifetime.
class WatchedShare {
  public:
    explicit WatchedShare(const WatchedLoop& loop) : watch_(loop.watch()), begin_(watch_ ? clock_now() : 0) {}
    ~WatchedShare() {
        if (watch_) watch_->worked(omp_get_thread_num(), begin_, clock_now());
    }
    WatchedShare(const WatchedShare&) = delete;
    WatchedShare& operator=(const WatchedShare&) = delete;

  private:
    LoopWatch* watch_;
    Nanoseconds begin_;
};

}  // namespace sluice
