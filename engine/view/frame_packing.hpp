// A frame in few bytes, for a page to unpack: numbers in 16 bits, each column compressed on its own, so that a reader
// pays for the columns that it shows.
//
// Packed frame: the length of a head (uint32, little-endian), the head (JSON: time, step, particles, columns), then the
// columns' bytes one after the other. A column of numbers is scaled to 0 … 65534 between its own `low` and `high` in
// this frame, 65535 = no value. Particles are sorted by id, and neighbours in id were neighbours in space, so what is
// stored are differences to the particle before, signs folded (0, −1, 1, −2 … → 0, 1, 2, 3 …), low bytes first and high
// bytes behind them, by zlib. A column of identities is the same from whole numbers of 32 bits.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/view/field.hpp"
#include "engine/view/frame_file.hpp"

namespace sluice {

struct PackedColumn {
    std::string name;
    float low = 0, high = 0;  ///< of numbers: what 0 and 65534 stand for
    int width = 2;            ///< bytes of a value: 2 numbers, 4 identities
    std::string bytes;
};

/// The highest step of a number; the one above means "no value".
constexpr std::uint32_t highest_step = 65534;

PackedColumn pack_numbers(const NumberColumn& column, int level);
template <class T>
PackedColumn pack_identities(std::string_view name, std::span<const T> values, int level);

/// What a reader gets back; off by half a step, (high − low)/65534/2, at the most. `count`: of particles.
std::vector<float> unpack_numbers(const PackedColumn& column, std::size_t count);
std::vector<std::uint32_t> unpack_identities(const PackedColumn& column, std::size_t count);

/// How a frame is packed. Columns: positions, fields, `group` (as `group_of` has it per particle), `id`.
struct FramePacking {
    int dimension = 2;
    std::vector<std::string> fields;  ///< of field_columns
    int level = 6;                    ///< zlib's, 1 (fast) to 9
};
std::string pack_frame(const StoredFrame& frame, std::span<const std::uint32_t> group_of, const FramePacking& packing);

/// Base64 of RFC 4648, as HTML can hold it.
std::string base64(std::string_view bytes);

}  // namespace sluice
