// Files are written by a thread of their own, so that a slow disk does not hold up the steps.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace sluice {

/// Does what it is given one after another, in the order in which it was given. What waits is bounded: who adds to a
/// full queue waits for it.
class BackgroundWriter {
  public:
    using Task = std::function<void()>;

    /// At most `capacity` bytes wait, or one task if that is larger. 0: there is no thread, `add` does the task.
    explicit BackgroundWriter(std::size_t capacity = default_capacity);
    /// Drains the queue. Exceptions are swallowed; call finish() to receive them.
    ~BackgroundWriter();
    BackgroundWriter(const BackgroundWriter&) = delete;
    BackgroundWriter& operator=(const BackgroundWriter&) = delete;

    /// `bytes`: of memory that the task holds. Throws what an earlier task has thrown, as `finish` does.
    void add(std::size_t bytes, Task task);
    /// Returns when all is done. Throws what a task has thrown; those that waited behind it are not done then, as if
    /// the program had stopped there. Only once: it goes on with what is added afterwards.
    void finish();

    /// How long `add` and `finish` have waited for the disk. [s]
    double waited() const { return waited_; }

    /// A few frames of a large scene. It is small beside the scene's own memory.
    static constexpr std::size_t default_capacity = 64 << 20;

  private:
    struct Waiting {
        std::size_t bytes;
        Task task;
    };
    template <class Done>
    void wait(std::unique_lock<std::mutex>& lock, Done&& done);
    void work();
    void throw_fault();

    std::size_t capacity_;
    std::size_t bytes_ = 0;  ///< that wait
    double waited_ = 0;      ///< [s]
    bool busy_ = false, stop_ = false;
    std::exception_ptr fault_;
    std::deque<Waiting> queue_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::thread thread_;  // last: it uses all of the above
};

}  // namespace sluice
