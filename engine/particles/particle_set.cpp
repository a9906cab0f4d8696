#include "engine/particles/particle_set.hpp"

#include <algorithm>

#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// A spare column of each type: the memory that one column leaves is used by the next.
struct Buffers {
    Array<double> reals;
    Array<std::uint64_t> ids;
    Array<std::uint16_t> numbers;
    Array<std::uint8_t> flags;

    Array<double>& of(const Array<double>&) { return reals; }
    Array<std::uint64_t>& of(const Array<std::uint64_t>&) { return ids; }
    Array<std::uint16_t>& of(const Array<std::uint16_t>&) { return numbers; }
    Array<std::uint8_t>& of(const Array<std::uint8_t>&) { return flags; }
};

}  // namespace

template <int Dim>
void ParticleSet<Dim>::reorder(const Array<Index>& order, std::size_t first) {
    Buffers buffers;
    for_each_array(*this, [&](const ColumnInfo&, auto& column) {
        if (column.empty()) return;
        auto& moved = buffers.of(column);
        moved.resize(owned);
        std::copy_n(column.begin(), first, moved.begin());
        parallel_for(order.size(), [&](std::size_t k) { moved[first + k] = column[order[k]]; });
        const std::size_t last = first + order.size();
        std::copy(column.begin() + static_cast<std::ptrdiff_t>(last),
                  column.begin() + static_cast<std::ptrdiff_t>(owned),
                  moved.begin() + static_cast<std::ptrdiff_t>(last));
        column.swap(moved);
    });
}

template struct ParticleSet<2>;
template struct ParticleSet<3>;

}  // namespace sluice
