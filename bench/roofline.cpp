#include "bench/roofline.hpp"

#include <benchmark/benchmark.h>
#include <time.h>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <string>
#include <utility>

#include "bench/suite.hpp"
#include "engine/run/profile/roofline_loops.hpp"
#include "neighbor/fields.hpp"

namespace sluice::bench {
namespace {

/// Runs of which the fastest counts: whatever disturbs a run makes it slower.
constexpr int tries = 5;

double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The highest of several rates; work() returns what it has done.
template <class Work>
double best_rate(Work&& work) {
    double best = 0;
    for (int n = 0; n < tries; ++n) {
        const double start = thread_seconds();
        const auto done = static_cast<double>(work());
        best = std::max(best, done / (thread_seconds() - start));
    }
    return best;
}

using MultiplyAdd = std::uint64_t (*)(std::uint64_t);

MultiplyAdd multiply_add_of(Isa isa, Precision precision) {
    if (precision == Precision::mixed) return SLUICE_OF_ISA(isa, multiply_add<float>);
    return SLUICE_OF_ISA(isa, multiply_add<double>);
}

/// Size of a level of cache, data or unified; a guess where the system does not tell.
std::size_t cache_bytes(int level, std::size_t otherwise) {
    for (const auto& cache : benchmark::CPUInfo::Get().caches)
        if (cache.level == level && cache.type != "Instruction") return static_cast<std::size_t>(cache.size);
    return otherwise;
}

/// Copies past the caches, so that what is counted is what goes over the bus: an ordinary store to memory first reads
/// the line that it overwrites.
void copy_past_caches(Array<char>& to, const Array<char>& from) {
#ifdef __SSE2__
    for (std::size_t b = 0; b < from.size(); b += sizeof(__m128i))
        _mm_stream_si128(reinterpret_cast<__m128i*>(to.data() + b),
                         _mm_load_si128(reinterpret_cast<const __m128i*>(from.data() + b)));
    _mm_sfence();
#else
    std::memcpy(to.data(), from.data(), from.size());
#endif
}

void copy_in_cache(Array<char>& to, const Array<char>& from) { std::memcpy(to.data(), from.data(), from.size()); }

/// Two arrays to copy between, touched once.
struct Copy {
    Array<char> from, to;
    void (*copy)(Array<char>&, const Array<char>&);

    /// Returns the bytes read and written.
    std::size_t operator()() {
        copy(to, from);
        benchmark::ClobberMemory();
        return 2 * from.size();
    }
};

Copy memory_copy() {
    const std::size_t bytes = 3 * cache_bytes(3, std::size_t{32} << 20);
    return {Array<char>(bytes, 1), Array<char>(bytes, 2), copy_past_caches};
}

/// Both arrays together take half of the cache.
Copy l2_copy() {
    const std::size_t bytes = cache_bytes(2, std::size_t{1} << 20) / 4;
    return {Array<char>(bytes, 1), Array<char>(bytes, 2), copy_in_cache};
}

void fma_benchmark(benchmark::State& state, Isa isa, Precision precision) {
    constexpr std::uint64_t rounds = 100000;
    const MultiplyAdd loop = multiply_add_of(isa, precision);
    std::uint64_t done = 0;
    for (auto _ : state) done += loop(rounds);
    state.counters["operations/s"] = benchmark::Counter(static_cast<double>(done), benchmark::Counter::kIsRate);
}

void copy_benchmark(benchmark::State& state, Copy (*make)()) {
    Copy copy = make();
    std::size_t done = 0;
    for (auto _ : state) done += copy();
    state.counters["bytes/s"] = benchmark::Counter(static_cast<double>(done), benchmark::Counter::kIsRate);
}

}  // namespace

double arithmetic_peak(Isa isa, Precision precision) {
    static std::map<std::pair<Isa, Precision>, double> measured;
    double& peak = measured[{isa, precision}];
    if (peak == 0) {
        constexpr std::uint64_t rounds = 1000000;  // 5 ms
        peak = best_rate([loop = multiply_add_of(isa, precision)] { return loop(rounds); });
    }
    return peak;
}

const CopyRate& copy_rate() {
    static const CopyRate measured = [] {
        constexpr int l2_copies = 200;
        Copy far = memory_copy(), near = l2_copy();
        const double l2 = best_rate([&] {
            std::size_t done = 0;
            for (int n = 0; n < l2_copies; ++n) done += near();
            return done;
        });
        return CopyRate{best_rate(far), l2};
    }();
    return measured;
}

void register_roofline() {
    for (const Isa isa : available_isas())
        for (const Precision precision : {Precision::mixed, Precision::full}) {
            const std::string number = precision == Precision::mixed ? "float" : "double";
            const std::string name = "roofline/fma/" + number + "/" + std::string(name_of(isa));
            benchmark::RegisterBenchmark(name.c_str(), fma_benchmark, isa, precision)->MeasureProcessCPUTime();
        }
    benchmark::RegisterBenchmark("roofline/copy/memory", copy_benchmark, memory_copy)->MeasureProcessCPUTime();
    benchmark::RegisterBenchmark("roofline/copy/l2", copy_benchmark, l2_copy)->MeasureProcessCPUTime();
}

}  // namespace sluice::bench
