// The parallel radix sort against std::stable_sort.
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "neighbor/radix_sort.hpp"
#include "tests/catch.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_radix_sort {

namespace {

struct Columns {
    Array<std::uint64_t> keys;
    Array<Index> values;
};

Columns random_columns(std::size_t n, std::uint64_t mask, unsigned seed) {
    Random random(seed);
    Columns c;
    for (std::size_t i = 0; i < n; ++i) {
        c.keys.push_back(random.bits() & mask);
        c.values.push_back(static_cast<Index>(i));
    }
    return c;
}

std::uint64_t lowest_bits(int n) { return n == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1; }

Columns sorted_by_the_library(const Columns& c, int key_bits) {
    std::vector<std::size_t> order(c.keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::uint64_t mask = lowest_bits(key_bits);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return (c.keys[a] & mask) < (c.keys[b] & mask); });
    Columns sorted;
    for (const std::size_t i : order) {
        sorted.keys.push_back(c.keys[i]);
        sorted.values.push_back(c.values[i]);
    }
    return sorted;
}

}  // namespace

TEST_CASE("the radix sort equals std::stable_sort", "[radix_sort]") {
    for (const int threads : {1, 2, 3, 4})
        for (const std::size_t n : {0, 1, 100, 100000, 5000})
            for (const int key_bits : {1, 3, 8, 13, 40, 62, 64}) {
                const ThreadScope scope(threads);
                Columns c = random_columns(n, lowest_bits(key_bits), 7);
                const Columns expected = sorted_by_the_library(c, key_bits);
                radix_sort(c.keys, c.values, key_bits);
                CAPTURE(threads, n, key_bits);
                CHECK((c.keys == expected.keys));
                CHECK((c.values == expected.values));
            }
}

TEST_CASE("bits above key_bits do not matter to the sort", "[radix_sort]") {
    for (const int key_bits : {1, 5, 8, 12, 33}) {
        Columns c = random_columns(10000, ~std::uint64_t{0}, 11);
        const Columns expected = sorted_by_the_library(c, key_bits);
        radix_sort(c.keys, c.values, key_bits);
        CAPTURE(key_bits);
        CHECK((c.keys == expected.keys));
        CHECK((c.values == expected.values));
    }
}

TEST_CASE("equal keys keep their order", "[radix_sort]") {
    for (const int threads : {1, 2, 4}) {
        const ThreadScope scope(threads);
        Columns c = random_columns(50000, 0, 3);
        const Columns before = c;
        radix_sort(c.keys, c.values, 16);
        CHECK(c.values == before.values);
    }
}

}  // namespace sluice::test_radix_sort
