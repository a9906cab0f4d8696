// The columns that particles can have, with names and units, from the one table (kernels/columns/columns.def).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace sluice {

enum class Column : std::uint8_t {
#define SLUICE_COLUMN(name, ...) name,
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN
};

/// What a column holds per particle: real numbers, or one whole number of 64, 16 or 8 bits.
enum class Rank : std::uint8_t { scalar, vector, symmetric, full, id, number, flag };

/// How a ghost gets a column from its parent: the same value; reflected or shifted, as a place or as a direction; not
/// at all.
enum class Mirror : std::uint8_t { same, place, direction, none };

/// Who sees a column: the engine alone, or programs in C++ and Python too.
enum class Access : std::uint8_t { internal, open };

struct ColumnInfo {
    Column column;
    std::string_view name, unit;
    Rank rank;
    Mirror mirror;
    Access access;
};

inline constexpr ColumnInfo column_table[] = {
#define SLUICE_COLUMN(name, unit, rank, mirror, access) \
    {Column::name, #name, unit, Rank::rank, Mirror::mirror, Access::access},
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN
};
inline constexpr std::size_t column_count = std::size(column_table);

constexpr const ColumnInfo& info_of(Column c) { return column_table[static_cast<std::size_t>(c)]; }

/// The number of components of a column.
template <int Dim>
constexpr int components_of(Rank rank) {
    switch (rank) {
        case Rank::vector:
            return Dim;
        case Rank::symmetric:
            return Dim * (Dim + 1) / 2;
        case Rank::full:
            return Dim * Dim;
        case Rank::scalar:
        case Rank::id:
        case Rank::number:
        case Rank::flag:
            return 1;
    }
    return 0;
}

/// A set of columns.
struct ColumnSet {
    std::uint64_t low = 0, high = 0;  ///< a bit for each column

    constexpr ColumnSet() = default;
    constexpr ColumnSet(std::uint64_t l, std::uint64_t h) : low(l), high(h) {}
    constexpr ColumnSet(Column c) : low(bit(c, 0)), high(bit(c, 64)) {}

    constexpr bool has(Column c) const { return ((low & bit(c, 0)) | (high & bit(c, 64))) != 0; }
    friend constexpr bool operator==(const ColumnSet&, const ColumnSet&) = default;

  private:
    static constexpr std::uint64_t bit(Column c, int first) {
        const int place = static_cast<int>(c) - first;
        return place >= 0 && place < 64 ? std::uint64_t{1} << place : 0;
    }
};
constexpr ColumnSet operator|(const ColumnSet& a, const ColumnSet& b) { return {a.low | b.low, a.high | b.high}; }
static_assert(column_count <= 128, "a ColumnSet has two words");

/// A column as a type: column::velocity, for choices made when a loop is compiled.
template <Column C>
struct ColumnTag {
    static constexpr Column column = C;
    constexpr operator ColumnSet() const { return C; }
};

namespace column {
#define SLUICE_COLUMN(name, ...) inline constexpr ColumnTag<Column::name> name;
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN
}  // namespace column

}  // namespace sluice
