#include "engine/view/frame_packing.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sluice {
namespace {

std::string deflated(const std::vector<unsigned char>& plain, int level) {
    uLongf size = compressBound(plain.size());
    std::string bytes(size, '\0');
    auto* out = reinterpret_cast<Bytef*>(bytes.data());
    if (compress2(out, &size, plain.data(), plain.size(), level) != Z_OK) throw std::bad_alloc();
    bytes.resize(size);
    return bytes;
}

std::vector<unsigned char> inflated(const std::string& bytes, std::size_t size) {
    std::vector<unsigned char> plain(size);
    uLongf got = size;
    const auto* in = reinterpret_cast<const Bytef*>(bytes.data());
    if (uncompress(plain.data(), &got, in, bytes.size()) != Z_OK || got != size)
        throw std::logic_error("a packed column of another length");
    return plain;
}

/// Differences, folded, by planes of bytes. T: unsigned, of the width that is stored; differences wrap around in it.
template <class T>
std::string pack(const std::vector<T>& values, int level) {
    const std::size_t n = values.size();
    std::vector<unsigned char> planes(n * sizeof(T));
    T before = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const T difference = static_cast<T>(values[i] - before);
        const bool negative = difference >> (8 * sizeof(T) - 1);
        const T folded = static_cast<T>((difference << 1) ^ (negative ? ~T{0} : T{0}));
        for (std::size_t b = 0; b < sizeof(T); ++b)
            planes[b * n + i] = static_cast<unsigned char>(folded >> (8 * b) & 0xFF);
        before = values[i];
    }
    return deflated(planes, level);
}

template <class T>
std::vector<T> unpack(const std::string& bytes, std::size_t n) {
    const std::vector<unsigned char> planes = inflated(bytes, n * sizeof(T));
    std::vector<T> values(n);
    T before = 0;
    for (std::size_t i = 0; i < n; ++i) {
        T folded = 0;
        for (std::size_t b = 0; b < sizeof(T); ++b) folded = static_cast<T>(folded | T{planes[b * n + i]} << (8 * b));
        before = static_cast<T>(before + ((folded >> 1) ^ (folded & 1 ? ~T{0} : T{0})));
        values[i] = before;
    }
    return values;
}

std::string head_text(const StoredFrame& frame, const std::vector<PackedColumn>& columns) {
    std::string list;
    for (const PackedColumn& c : columns)
        list += fmt::format(R"({}{{"name":"{}","width":{},"low":{},"high":{},"bytes":{}}})", list.empty() ? "" : ",",
                            c.name, c.width, c.low, c.high, c.bytes.size());
    return fmt::format(R"({{"time":{},"step":{},"particles":{},"columns":[{}]}})", frame.time, frame.step,
                       frame.table.particles, list);
}

}  // namespace

PackedColumn pack_numbers(const NumberColumn& column, int level) {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    for (std::size_t i = 0; i < column.count; ++i)
        if (std::isfinite(column[i])) low = std::min(low, column[i]), high = std::max(high, column[i]);
    if (low > high) low = high = 0;  // no value anywhere
    const double per_unit = high > low ? highest_step / (static_cast<double>(high) - low) : 0.0;
    std::vector<std::uint16_t> steps(column.count);
    for (std::size_t i = 0; i < column.count; ++i) {
        const float value = column[i];
        steps[i] = static_cast<std::uint16_t>(
            std::isfinite(value) ? std::lround((static_cast<double>(value) - low) * per_unit) : highest_step + 1);
    }
    return {column.name, low, high, 2, pack(steps, level)};
}

template <class T>
PackedColumn pack_identities(std::string_view name, std::span<const T> values, int level) {
    std::vector<std::uint32_t> low;  // their low 32 bits: a page does not show four thousand million particles
    for (const T value : values) low.push_back(static_cast<std::uint32_t>(value));
    return {std::string(name), 0, 0, 4, pack(low, level)};
}
template PackedColumn pack_identities<std::uint32_t>(std::string_view, std::span<const std::uint32_t>, int);
template PackedColumn pack_identities<std::uint64_t>(std::string_view, std::span<const std::uint64_t>, int);

std::vector<float> unpack_numbers(const PackedColumn& column, std::size_t count) {
    std::vector<float> values;
    for (const std::uint16_t step : unpack<std::uint16_t>(column.bytes, count))
        values.push_back(step > highest_step
                             ? std::numeric_limits<float>::quiet_NaN()
                             : static_cast<float>(column.low + (static_cast<double>(column.high) - column.low) * step /
                                                                   highest_step));
    return values;
}

std::vector<std::uint32_t> unpack_identities(const PackedColumn& column, std::size_t count) {
    return unpack<std::uint32_t>(column.bytes, count);
}

std::string pack_frame(const StoredFrame& frame, std::span<const std::uint32_t> group_of, const FramePacking& packing) {
    std::vector<NumberColumn> numbers = position_columns(frame.table, packing.dimension);
    for (const NumberColumn& column : field_columns(frame.table, packing.dimension))
        if (std::find(packing.fields.begin(), packing.fields.end(), column.name) != packing.fields.end())
            numbers.push_back(column);
    const std::size_t n = numbers.size();
    std::vector<PackedColumn> columns(n + 2);
#pragma omp parallel for schedule(dynamic)
    for (std::size_t k = 0; k < n + 2; ++k) {
        if (k < n) columns[k] = pack_numbers(numbers[k], packing.level);
        if (k == n) columns[k] = pack_identities<std::uint32_t>("group", group_of, packing.level);
        if (k == n + 1) columns[k] = pack_identities<std::uint64_t>("id", frame.table.id, packing.level);
    }
    const std::string head = head_text(frame, columns);
    std::string packed;
    for (std::size_t b = 0; b < 4; ++b) packed += static_cast<char>(head.size() >> (8 * b) & 0xFF);
    packed += head;
    for (const PackedColumn& column : columns) packed += column.bytes;
    return packed;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < left ? static_cast<unsigned char>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k) text += k <= left ? letters[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace sluice
