// The columns of a set of particles, a member each. Columns that no effect needs stay empty.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "kernels/columns/column_table.hpp"
#include "neighbor/fields.hpp"

namespace sluice {

namespace detail {

template <int Dim, Rank R>
struct ColumnTypes {
    using Field = TupleField<components_of<Dim>(R)>;
};
template <int Dim>
struct ColumnTypes<Dim, Rank::scalar> {
    using Field = ScalarField;
};
template <int Dim>
struct ColumnTypes<Dim, Rank::id> {
    using Field = Array<std::uint64_t>;
};
template <int Dim>
struct ColumnTypes<Dim, Rank::number> {
    using Field = Array<std::uint16_t>;
};
template <int Dim>
struct ColumnTypes<Dim, Rank::flag> {
    using Field = Array<std::uint8_t>;
};

}  // namespace detail

/// A column of Rank::number holds 0 … most_numbers − 1: the most bodies, and the most walls, that a scene can have.
inline constexpr std::size_t most_numbers = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;

/// The container for a column of this rank: an Array, or a TupleField with an array per component.
template <int Dim, Rank R>
using FieldOf = typename detail::ColumnTypes<Dim, R>::Field;

template <int Dim>
struct Columns {
#define SLUICE_COLUMN(name, unit, rank, mirror, access) FieldOf<Dim, Rank::rank> name;
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN

    /// The member by its tag: columns[column::velocity] is columns.velocity.
#define SLUICE_COLUMN(name, ...)                                     \
    auto& operator[](ColumnTag<Column::name>) { return this->name; } \
    const auto& operator[](ColumnTag<Column::name>) const { return this->name; }
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN
};

/// visit(tag, field) for each column: a ColumnTag<C>, and the member.
template <class ColumnsOfDim, class Visit>
void for_each_field(ColumnsOfDim& columns, Visit&& visit) {
#define SLUICE_COLUMN(name, ...) visit(column::name, columns.name);
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN
}

/// visit(array) for each component of a field.
template <class T, class Visit>
void for_each_component(Array<T>& field, Visit&& visit) {
    visit(field);
}
template <class T, class Visit>
void for_each_component(const Array<T>& field, Visit&& visit) {
    visit(field);
}
template <int N, class Visit>
void for_each_component(TupleField<N>& field, Visit&& visit) {
    for (auto& component : field.c) visit(component);
}
template <int N, class Visit>
void for_each_component(const TupleField<N>& field, Visit&& visit) {
    for (const auto& component : field.c) visit(component);
}

/// visit(info, array) for each component of each column, allocated or not.
template <class ColumnsOfDim, class Visit>
void for_each_array(ColumnsOfDim& columns, Visit&& visit) {
    for_each_field(columns, [&](auto tag, auto& field) {
        for_each_component(field, [&](auto& array) { visit(info_of(tag.column), array); });
    });
}

/// The memory of all columns, in bytes.
template <int Dim>
std::size_t bytes_of(const Columns<Dim>& columns) {
    std::size_t bytes = 0;
    for_each_array(columns,
                   [&](const ColumnInfo&, const auto& array) { bytes += array.capacity() * sizeof(array[0]); });
    return bytes;
}

}  // namespace sluice
