// Morton keys against their definition, bit by bit.
#include <algorithm>
#include <limits>

#include "neighbor/morton.hpp"
#include "tests/catch.hpp"
#include "tests/neighbor/clouds.hpp"

namespace sluice::test_morton {

namespace {

/// The definition: bit b of coordinate k is bit b·Dim + k of the key.
template <int Dim>
std::uint64_t interleave(const std::array<std::uint32_t, Dim>& cell) {
    std::uint64_t key = 0;
    for (int b = 0; b < morton_bits<Dim>; ++b)
        for (int k = 0; k < Dim; ++k)
            key |= static_cast<std::uint64_t>(cell[static_cast<std::size_t>(k)] >> b & 1u) << (b * Dim + k);
    return key;
}

template <int Dim>
constexpr std::uint32_t largest_coordinate = static_cast<std::uint32_t>((std::uint64_t{1} << morton_bits<Dim>)-1);

}  // namespace

TEMPLATE_TEST_CASE_SIG("a Morton key interleaves the coordinates' bits", "[morton]", ((int Dim), Dim), 2, 3) {
    Random random(1);
    std::size_t wrong = 0;
    for (int n = 0; n < 20000; ++n) {
        std::array<std::uint32_t, Dim> cell;
        for (auto& c : cell) c = static_cast<std::uint32_t>(random.bits()) & largest_coordinate<Dim>;
        wrong += morton_encode<Dim>(cell) != interleave<Dim>(cell);
    }
    CHECK(wrong == 0);
    for (std::size_t k = 0; k < Dim; ++k)
        for (const std::uint32_t value : {0u, 1u, largest_coordinate<Dim> / 2 + 1, largest_coordinate<Dim>}) {
            std::array<std::uint32_t, Dim> cell{};
            cell[k] = value;
            CAPTURE(k, value);
            CHECK(morton_encode<Dim>(cell) == interleave<Dim>(cell));
        }
}

TEMPLATE_TEST_CASE_SIG("Morton keys use the key's whole range and nothing above it", "[morton]", ((int Dim), Dim), 2,
                       3) {
    std::array<std::uint32_t, Dim> corner;
    corner.fill(largest_coordinate<Dim>);
    constexpr int bits = Dim * morton_bits<Dim>;
    CHECK(morton_encode<Dim>(corner) == std::numeric_limits<std::uint64_t>::max() >> (64 - bits));
    CHECK(morton_encode<Dim>(std::array<std::uint32_t, Dim>{}) == 0);
}

TEST_CASE("a Morton key is known at compile time", "[morton]") {
    STATIC_REQUIRE(morton_encode<2>({1, 0}) == 1);
    STATIC_REQUIRE(morton_encode<2>({0, 1}) == 2);
    STATIC_REQUIRE(morton_encode<3>({0, 0, 1}) == 4);
    STATIC_REQUIRE(morton_encode<3>({2, 0, 0}) == 8);
}

}  // namespace sluice::test_morton
