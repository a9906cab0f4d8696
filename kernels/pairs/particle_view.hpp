// Read-only views of columns for the loops over pairs.
#pragma once

#include <array>

#include "kernels/columns/columns.hpp"

namespace sluice {

/// Pointers to the components of a tuple field; the pointer to a plain array, null if it is empty.
template <int N>
std::array<const double*, N> columns_of(const TupleField<N>& field) {
    std::array<const double*, N> p;
    for (std::size_t k = 0; k < N; ++k) p[k] = field.c[k].data();
    return p;
}
template <class T>
const T* columns_of(const Array<T>& column) {
    return column.empty() ? nullptr : column.data();
}

/// The columns of a set of particles, read-only. A pass reads the columns that its terms name; the others may be null.
template <int Dim>
struct ParticleView {
    template <Rank R>
    using Pointers = decltype(columns_of(std::declval<const FieldOf<Dim, R>&>()));

#define SLUICE_COLUMN(name, unit, rank, mirror, access) Pointers<Rank::rank> name{};
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN

#define SLUICE_COLUMN(name, ...)                                     \
    auto& operator[](ColumnTag<Column::name>) { return this->name; } \
    const auto& operator[](ColumnTag<Column::name>) const { return this->name; }
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN
};

/// A view of all columns; null where a column is empty.
template <int Dim>
ParticleView<Dim> view_of(const Columns<Dim>& columns) {
    ParticleView<Dim> view;
    for_each_field(columns, [&](auto tag, const auto& field) { view[tag] = columns_of(field); });
    return view;
}

/// Entry i of a tuple of columns.
template <std::size_t N>
[[gnu::always_inline]] inline Vec<static_cast<int>(N)> at(const std::array<const double*, N>& columns, std::size_t i) {
    Vec<static_cast<int>(N)> v;
    for (std::size_t k = 0; k < N; ++k) v[static_cast<int>(k)] = columns[k][i];
    return v;
}

/// The slots of gathered columns: the place, the smoothing length, then those of `Reads` in the order of the table.
/// Each term names what it reads in `reads_i` and `reads_j`; only the columns of a pack's terms are gathered. The place
/// is the column between whose values distances are measured; it has the first slots whether it is named or not.
template <int Dim, ColumnSet Reads>
struct Slots {
    static constexpr int smoothing_length = Dim;
    static constexpr int width(Column c) { return components_of<Dim>(info_of(c).rank); }
    /// First slot of a column.
    static constexpr int of(Column c) {
        int slot = Dim + 1;
        for (const ColumnInfo& info : column_table)
            if (info.column < c && Reads.has(info.column)) slot += width(info.column);
        return slot;
    }
    static constexpr int count = [] {
        int slots = Dim + 1;
        for (const ColumnInfo& info : column_table)
            if (Reads.has(info.column)) slots += width(info.column);
        return slots;
    }();
    using Pointers = std::array<const double*, static_cast<std::size_t>(count)>;

    /// Pointers to the columns of a view, slot by slot.
    template <Column Place>
    [[gnu::always_inline]] static Pointers of_view(const ParticleView<Dim>& view, ColumnTag<Place> place) {
        Pointers p{};
        put(0, view[place], p);
        put(smoothing_length, view.smoothing_length, p);
#define SLUICE_COLUMN(name, ...) \
    if constexpr (Reads.has(Column::name)) put(of(Column::name), view.name, p);
#include "kernels/columns/columns.def"
#undef SLUICE_COLUMN
        return p;
    }

  private:
    template <std::size_t N>
    [[gnu::always_inline]] static void put(int slot, const std::array<const double*, N>& columns, Pointers& p) {
        for (std::size_t k = 0; k < N; ++k) p[static_cast<std::size_t>(slot) + k] = columns[k];
    }
    [[gnu::always_inline]] static void put(int slot, const double* column, Pointers& p) {
        p[static_cast<std::size_t>(slot)] = column;
    }
};

}  // namespace sluice
