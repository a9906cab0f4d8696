#include "engine/run/profile/machine_limits.hpp"

#include <omp.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "engine/run/profile/roofline_loops.hpp"
#include "engine/run/profile/step_profile.hpp"
#include "neighbor/fields.hpp"
#include "neighbor/loop_watch.hpp"
#include "neighbor/thread_count.hpp"

namespace sluice {
namespace {

constexpr int tries = 5, patience = 20;

/// Of the first core's data or unified cache of a level, as Linux tells it ("1024K"); a guess where it does not. The C
/// library's sysconf() tells the last-level cache of a whole processor, of which a core may see a tenth.
std::size_t cache_bytes(int level, std::size_t otherwise) {
    for (int index = 0; index < 8; ++index) {
        const std::string folder = "/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(index) + "/";
        const auto read = [&](const char* name, auto& value) {
            return static_cast<bool>(std::ifstream(folder + name) >> value);
        };
        int its_level = 0;
        std::string type;
        std::size_t kilobytes = 0;
        if (read("level", its_level) && its_level == level && read("type", type) && type != "Instruction" &&
            read("size", kilobytes))
            return kilobytes << 10;
    }
    return otherwise;
}

/// The highest of several rates that nothing interrupted, if there are so many before the patience ends.
///
/// `work` is done by each thread at the same time; it returns what it has done.
template <class Work>
double best_rate(int threads, Work work) {
    const ThreadCount count(threads);
    double best = 0;
    for (int n = 0, calm = 0; n < patience && calm < tries; ++n) {
        const long interruptions_before = interruptions();
        double done = 0;
        Nanoseconds start = 0;
#pragma omp parallel reduction(+ : done)
        {
#pragma omp barrier
#pragma omp master
            start = clock_now();
            done = static_cast<double>(work());
        }
        best = std::max(best, 1e9 * done / static_cast<double>(clock_now() - start));
        if (interruptions() == interruptions_before) ++calm;
    }
    return best;
}

template <class Work>
Limit limit_of(int threads, const Work& work_on) {
    const double one = best_rate(1, work_on(1));
    if (threads == 1) return {one, one};
    const double all = best_rate(threads, work_on(threads));
    return {std::max(one, all / threads), all};  // one alone is at least as fast as one of several
}

template <class Number>
Limit arithmetic(int threads) {
    constexpr std::uint64_t rounds = 1'000'000;  // 5 ms
    const auto loop = SLUICE_OF_ISA(active_isa(), multiply_add<Number>);
    return limit_of(threads, [&](int) { return [loop] { return loop(rounds); }; });
}

/// Three arrays per thread, of so many bytes together.
Limit bandwidth(int threads, std::size_t bytes_per_thread, std::size_t bytes_of_all) {
    constexpr std::size_t bytes_moved = 20'000'000;  // of each thread and try, at least: some milliseconds
    const auto loop = SLUICE_OF_ISA(active_isa(), triad);
    return limit_of(threads, [&](int on) {
        const std::size_t bytes = std::min(bytes_per_thread, bytes_of_all / static_cast<std::size_t>(on));
        const std::size_t n = bytes / (3 * sizeof(double));
        std::vector<std::array<Array<double>, 3>> arrays(static_cast<std::size_t>(on));
        {
            const ThreadCount count(on);
#pragma omp parallel
            for (Array<double>& array : arrays[static_cast<std::size_t>(omp_get_thread_num())]) array.assign(n, 1);
        }
        return [loop, n, arrays = std::move(arrays)]() mutable {
            auto& own = arrays[static_cast<std::size_t>(omp_get_thread_num())];
            std::uint64_t done = 0;
            while (done < bytes_moved) done += loop(own[0].data(), own[1].data(), own[2].data(), n);
            return done;
        };
    });
}

}  // namespace

const MemoryLevel& MachineLimits::level_of(double bytes, int on_threads) const {
    for (const MemoryLevel& level : memory) {
        const double holds = static_cast<double>(level.bytes) * (level.shared ? 1 : on_threads);
        if (bytes <= holds) return level;
    }
    return memory.back();
}

MachineLimits measure_machine(int threads) {
    MachineLimits m{active_isa(), threads, arithmetic<float>(threads), arithmetic<double>(threads), {}};
    const std::size_t l2 = cache_bytes(2, std::size_t{1} << 20);
    const std::size_t last = std::max(cache_bytes(3, 0), l2);
    // Each array four times the last-level cache [McCalpin1995], within reason; half of a cache, so that all stays in
    // it.
    const std::size_t far = 3 * std::clamp(4 * last, std::size_t{64} << 20, std::size_t{256} << 20);
    m.memory = {{{"L2", l2, false, bandwidth(threads, l2 / 2, threads * l2)},
                 {"L3", last, true, bandwidth(threads, last / 2, last / 2)},
                 {"memory", 0, true, bandwidth(threads, far, far)}}};
    return m;
}

}  // namespace sluice
