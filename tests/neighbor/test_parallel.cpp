// Loops on all threads, and reductions that do not depend on how many there are.
#include <bit>
#include <limits>
#include <vector>

#include "neighbor/parallel.hpp"
#include "tests/catch.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_parallel {

namespace {

/// Numbers whose sum depends on the order of addition.
std::vector<double> ill_matched(std::size_t n) {
    Random random(5);
    std::vector<double> v;
    for (std::size_t i = 0; i < n; ++i) v.push_back(random.in(-1, 1) * std::exp(random.in(-20, 20)));
    return v;
}

}  // namespace

TEST_CASE("every iteration runs once", "[parallel]") {
    for (const int threads : {1, 2, 4})
        for (const std::size_t n :
             {std::size_t{0}, std::size_t{1}, light_threshold, light_threshold + 1, std::size_t{10007}}) {
            const ThreadScope scope(threads);
            std::vector<int> visits(n, 0);
            parallel_for(n, [&](std::size_t i) { ++visits[i]; });
            CAPTURE(threads, n);
            CHECK(visits == std::vector<int>(n, 1));
        }
}

TEST_CASE("ordered_sum has the same bits for any number of threads", "[parallel]") {
    // 600,000 items are more blocks than ordered_sum keeps on its stack, and enough for a team of threads.
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{1024}, std::size_t{1025},
                                std::size_t{70000}, std::size_t{600000}}) {
        const auto v = ill_matched(n);
        std::vector<std::uint64_t> bits;
        for (const int threads : {1, 2, 3, 4}) {
            const ThreadScope scope(threads);
            bits.push_back(std::bit_cast<std::uint64_t>(ordered_sum<double>(n, [&](std::size_t i) { return v[i]; })));
        }
        CAPTURE(n);
        CHECK(bits == std::vector<std::uint64_t>(4, bits[0]));
    }
}

TEST_CASE("ordered_sum adds up all items, of any type with a zero and +=", "[parallel]") {
    for (const std::size_t n : {0, 1, 1023, 1024, 1025, 65536, 65537, 200000}) {
        const auto sum = ordered_sum<Vec<3>>(n, [](std::size_t i) { return Vec<3>{{1, static_cast<double>(i), -1}}; });
        const double count = static_cast<double>(n);
        CAPTURE(n);
        CHECK(sum == Vec<3>{{count, count * (count - 1) / 2, -count}});  // whole numbers: exact
    }
}

TEST_CASE("nonnegative_max is a maximum that is never below zero", "[parallel]") {
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        for (const std::size_t n : {1, 10, 600, 5000}) {
            CHECK(nonnegative_max(n, [&](std::size_t i) { return i == n / 2 ? 7.5 : -1.0; }) == 7.5);
            CHECK(nonnegative_max(n, [](std::size_t) { return -3.0; }) == 0);
        }
        CHECK(nonnegative_max(0, [](std::size_t) { return 1.0; }) == 0);
    }
}

TEST_CASE("nonnegative_max returns NaN if there is one, wherever it stands", "[parallel]") {
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        for (const std::size_t n : {1, 2, 600, 5000})
            for (const std::size_t at : {std::size_t{0}, n / 2, n - 1}) {
                CAPTURE(threads, n, at);
                CHECK(std::isnan(nonnegative_max(n, [&](std::size_t i) {
                    return i == at ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(i);
                })));
            }
    }
}

}  // namespace sluice::test_parallel
