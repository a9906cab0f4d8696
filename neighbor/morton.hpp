// Morton (Z-order) keys: interleaved bits of cell coordinates, so that cells near in space are near in memory.
#pragma once

#include <array>
#include <cstdint>

namespace sluice {

/// Bits per coordinate that a 64-bit key holds.
template <int Dim>
inline constexpr int morton_bits = Dim == 2 ? 32 : 21;

namespace detail {

/// Puts one zero bit between neighbouring bits of a 32-bit number.
constexpr std::uint64_t spread_by_2(std::uint64_t v) {
    v &= 0xffffffffULL;
    v = (v | v << 16) & 0x0000ffff0000ffffULL;
    v = (v | v << 8) & 0x00ff00ff00ff00ffULL;
    v = (v | v << 4) & 0x0f0f0f0f0f0f0f0fULL;
    v = (v | v << 2) & 0x3333333333333333ULL;
    v = (v | v << 1) & 0x5555555555555555ULL;
    return v;
}

/// Puts two zero bits between neighbouring bits of a 21-bit number.
constexpr std::uint64_t spread_by_3(std::uint64_t v) {
    v &= 0x1fffffULL;
    v = (v | v << 32) & 0x001f00000000ffffULL;
    v = (v | v << 16) & 0x001f0000ff0000ffULL;
    v = (v | v << 8) & 0x100f00f00f00f00fULL;
    v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
    v = (v | v << 2) & 0x1249249249249249ULL;
    return v;
}

}  // namespace detail

/// The key of a cell; coordinates must be below 2^`morton_bits<Dim>`.
template <int Dim>
constexpr std::uint64_t morton_encode(const std::array<std::uint32_t, Dim>& cell) {
    std::uint64_t key = 0;
    for (int k = 0; k < Dim; ++k) {
        const std::uint64_t spread = Dim == 2 ? detail::spread_by_2(cell[static_cast<std::size_t>(k)])
                                              : detail::spread_by_3(cell[static_cast<std::size_t>(k)]);
        key |= spread << k;
    }
    return key;
}

}  // namespace sluice
