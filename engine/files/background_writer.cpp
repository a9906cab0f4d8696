#include "engine/files/background_writer.hpp"

#include <utility>

#include "engine/base/wall_clock.hpp"

namespace sluice {

BackgroundWriter::BackgroundWriter(std::size_t capacity) : capacity_(capacity) {
    if (capacity > 0) thread_ = std::thread([this] { work(); });
}

BackgroundWriter::~BackgroundWriter() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

template <class Done>
void BackgroundWriter::wait(std::unique_lock<std::mutex>& lock, Done&& done) {
    const auto start = WallClock::now();
    changed_.wait(lock, done);
    waited_ += seconds_since(start);
}

void BackgroundWriter::add(std::size_t bytes, Task task) {
    if (!thread_.joinable()) return task();
    std::unique_lock lock(mutex_);
    wait(lock, [&] { return fault_ || queue_.empty() || bytes_ + bytes <= capacity_; });
    throw_fault();
    queue_.push_back({bytes, std::move(task)});
    bytes_ += bytes;
    changed_.notify_all();
}

void BackgroundWriter::finish() {
    std::unique_lock lock(mutex_);
    wait(lock, [&] { return fault_ || (queue_.empty() && !busy_); });
    throw_fault();
}

/// With the lock held.
void BackgroundWriter::throw_fault() {
    if (fault_) std::rethrow_exception(std::exchange(fault_, nullptr));
}

void BackgroundWriter::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return stop_ || !queue_.empty(); });
        if (queue_.empty()) return;
        Waiting next = std::move(queue_.front());
        queue_.pop_front();
        bytes_ -= next.bytes;
        busy_ = true;
        lock.unlock();
        std::exception_ptr fault;
        try {
            next.task();
        } catch (...) {
            fault = std::current_exception();
        }
        next.task = nullptr;  // its memory, before the next one is let in
        lock.lock();
        busy_ = false;
        if (fault) {
            fault_ = fault;
            queue_.clear();
            bytes_ = 0;
        }
        changed_.notify_all();
    }
}

}  // namespace sluice
