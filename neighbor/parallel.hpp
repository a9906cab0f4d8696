// Loops over particles on all threads, and reductions whose result does not depend on how many threads there are.
#pragma once

#include <omp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "neighbor/loop_watch.hpp"

namespace sluice {

/// Below this many items a loop over pairs runs on the calling thread: a team's fork and join cost more than the work.
inline constexpr std::size_t parallel_threshold = 512;
/// The same for loops that do a few operations per item. They gain less from the second thread's arithmetic than from
/// its cache, where half of the columns already are.
inline constexpr std::size_t light_threshold = 2048;

/// body(i) for every i in [0, n), a few operations each; iterations must not depend on each other.
template <class Body>
void parallel_for(std::size_t n, Body&& body) {
    const auto run = [&body](std::size_t begin, std::size_t end) {
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
        for (std::size_t i = begin; i < end; ++i) body(i);
    };
    if (n <= light_threshold) return run(0, n);
    const WatchedLoop loop;
#pragma omp parallel
    {
        const WatchedShare share(loop);
        const auto t = static_cast<std::size_t>(omp_get_thread_num());
        const auto threads = static_cast<std::size_t>(omp_get_num_threads());
        run(n * t / threads, n * (t + 1) / threads);
    }
}

/// The same for bodies worth a microsecond or more each, of unequal cost.
template <class Body>
void parallel_for_heavy(std::size_t n, Body&& body) {
    const auto count = static_cast<std::int64_t>(n);
    const WatchedLoop loop;
#pragma omp parallel if (n > 8)
    {
        const WatchedShare share(loop);
#pragma omp for schedule(dynamic, 4) nowait
        for (std::int64_t i = 0; i < count; ++i) body(static_cast<std::size_t>(i));
    }
}

/// Σ f(i), added up in fixed blocks and then block by block: the same bits for any number of threads.
/// T needs a zero default and +=.
template <class T, class F>
T ordered_sum(std::size_t n, F&& f) {
    constexpr std::size_t block = 1024;
    const std::size_t blocks = (n + block - 1) / block;
    std::array<T, 64> on_stack{};  // 64 blocks without an allocation
    std::vector<T> on_heap;
    T* partial = on_stack.data();
    if (blocks > on_stack.size()) {
        on_heap.resize(blocks);
        partial = on_heap.data();
    }
    const auto count = static_cast<std::int64_t>(blocks);
    const WatchedLoop loop;
#pragma omp parallel if (n > light_threshold)
    {
        const WatchedShare share(loop);
#pragma omp for schedule(static) nowait
        for (std::int64_t k = 0; k < count; ++k) {
            const auto b = static_cast<std::size_t>(k);
            T s{};
            for (std::size_t i = b * block; i < std::min(n, (b + 1) * block); ++i) s += f(i);
            partial[b] = s;
        }
    }
    T total{};
    for (std::size_t b = 0; b < blocks; ++b) total += partial[b];
    return total;
}

/// max f(i), at least 0. The order of a maximum does not matter; NaN if any f(i) is not finite.
template <class F>
double nonnegative_max(std::size_t n, F&& f) {
    double largest = 0;
    bool all_finite = true;
    const auto count = static_cast<std::int64_t>(n);
    const WatchedLoop loop;
#pragma omp parallel reduction(max : largest) reduction(&& : all_finite) if (n > light_threshold)
    {
        const WatchedShare share(loop);
#pragma omp for schedule(static) nowait
        for (std::int64_t i = 0; i < count; ++i) {
            const double v = f(static_cast<std::size_t>(i));
            all_finite = all_finite && (v - v == 0);
            largest = std::max(largest, v);
        }
    }
    return all_finite ? largest : __builtin_nan("");
}

}  // namespace sluice
