#include "engine/state/reorder.hpp"

#include "engine/state/visit.hpp"
#include "neighbor/parallel.hpp"

namespace sluice {
namespace {

template <class Phase>
void reorder_columns(Phase& phase, const Array<Index>& order) {
    visit_columns(phase, [&](auto& column) {
        if (column.empty()) return;
        using Column = std::remove_reference_t<decltype(column)>;
        Column moved(order.size());
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

template void reorder<2>(FluidPhase<2>&, const Array<Index>&);
template void reorder<3>(FluidPhase<3>&, const Array<Index>&);
template void reorder<2>(SolidPhase<2>&, const Array<Index>&);
template void reorder<3>(SolidPhase<3>&, const Array<Index>&);

}  // namespace sluice
