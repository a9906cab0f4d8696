#include "engine/state/reorder.hpp"

#include "engine/state/visit.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

/// A spare column of each type: one column's old memory is the next one's new.
struct Buffers {
    Array<double> reals;
    Array<std::uint32_t> words;
    Array<std::uint16_t> halves;
    Array<std::uint8_t> bytes;
};
Array<double>& buffer_for(Buffers& b, const Array<double>&) { return b.reals; }
Array<std::uint32_t>& buffer_for(Buffers& b, const Array<std::uint32_t>&) { return b.words; }
Array<std::uint16_t>& buffer_for(Buffers& b, const Array<std::uint16_t>&) { return b.halves; }
Array<std::uint8_t>& buffer_for(Buffers& b, const Array<std::uint8_t>&) { return b.bytes; }

template <class Phase>
void reorder_columns(Phase& phase, const Array<Index>& order) {
    Buffers buffers;
    visit_columns(phase, [&](std::string_view, auto& column) {
        if (column.empty()) return;
        auto& moved = buffer_for(buffers, column);
        moved.resize(order.size());
        parallel_for(order.size(), [&](std::size_t k) { moved[k] = column[order[k]]; });
        column.swap(moved);
    });
    phase.owned = order.size();
}

}  // namespace

template <int Dim>
void reorder(FluidPhase<Dim>& phase, const Array<Index>& order) {
    reorder_columns(phase, order);
}
template <int Dim>
void reorder(SolidPhase<Dim>& phase, const Array<Index>& order) {
    reorder_columns(phase, order);
}
template <int Dim>
void reorder(WallPhase<Dim>& phase, const Array<Index>& order) {
    reorder_columns(phase, order);
}

#define SLUICE_INSTANTIATE(Dim)                                        \
    template void reorder<Dim>(FluidPhase<Dim>&, const Array<Index>&); \
    template void reorder<Dim>(SolidPhase<Dim>&, const Array<Index>&); \
    template void reorder<Dim>(WallPhase<Dim>&, const Array<Index>&);
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice
