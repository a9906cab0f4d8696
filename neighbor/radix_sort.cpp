#include "neighbor/radix_sort.hpp"

#include <omp.h>

#include <algorithm>

#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

constexpr int digit_bits = 8;
constexpr std::size_t digits = std::size_t{1} << digit_bits;

/// First item of a thread's contiguous share.
std::size_t share_begin(std::size_t n, int thread, int threads) {
    return n * static_cast<std::size_t>(thread) / static_cast<std::size_t>(threads);
}

/// Counts [thread][digit] → where each thread's first item of each digit goes: digit by digit, thread by thread.
void exclusive_offsets(Array<std::uint32_t>& counts, int threads) {
    std::uint32_t sum = 0;
    for (std::size_t d = 0; d < digits; ++d)
        for (int t = 0; t < threads; ++t) {
            std::uint32_t& c = counts[static_cast<std::size_t>(t) * digits + d];
            const std::uint32_t here = c;
            c = sum;
            sum += here;
        }
}

}  // namespace

void radix_sort(Array<std::uint64_t>& keys, Array<Index>& values, int key_bits) {
    const std::size_t n = keys.size();
    Array<std::uint64_t> key_buffer(n);
    Array<Index> value_buffer(n);
    Array<std::uint32_t> offsets;  // [thread][digit]
    const int threads = n > light_threshold ? omp_get_max_threads() : 1;
    for (int shift = 0; shift < key_bits; shift += digit_bits) {
        const std::uint64_t mask = (std::uint64_t{1} << std::min(digit_bits, key_bits - shift)) - 1;
        offsets.assign(static_cast<std::size_t>(threads) * digits, 0);
        const WatchedLoop loop;
#pragma omp parallel num_threads(threads) if (threads > 1)
        {
            const WatchedShare share(loop);
            // A runtime may grant fewer threads than asked for: shares are dealt out by share number, not by thread.
            const int granted = omp_get_num_threads();
            for (int t = omp_get_thread_num(); t < threads; t += granted) {
                std::uint32_t* count = &offsets[static_cast<std::size_t>(t) * digits];
                for (std::size_t i = share_begin(n, t, threads); i < share_begin(n, t + 1, threads); ++i)
                    ++count[(keys[i] >> shift) & mask];
            }
#pragma omp barrier
#pragma omp single
            exclusive_offsets(offsets, threads);
            for (int t = omp_get_thread_num(); t < threads; t += granted) {
                std::uint32_t* next = &offsets[static_cast<std::size_t>(t) * digits];
                for (std::size_t i = share_begin(n, t, threads); i < share_begin(n, t + 1, threads); ++i) {
                    const std::uint32_t to = next[(keys[i] >> shift) & mask]++;
                    key_buffer[to] = keys[i];
                    value_buffer[to] = values[i];
                }
            }
        }
        keys.swap(key_buffer);
        values.swap(value_buffer);
    }
}

}  // namespace sluice
