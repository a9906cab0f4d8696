// The loops between interface elements and particles, compiled once per instruction set.
#include "kernels/passes/interface_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

#define SLUICE_INSTANTIATE(Dim, Number)                   \
    SLUICE_INSTANTIATE_PASS(Number, ElementPressure<Dim>) \
    SLUICE_INSTANTIATE_PASS(Number, ElementWeights<Dim>)  \
    SLUICE_INSTANTIATE_PASS(Number, ForceShare<Dim>)      \
    SLUICE_INSTANTIATE_PASS(Number, SurfaceIntegral<Dim>) \
    SLUICE_INSTANTIATE_PASS(Number, SurfaceFlux<Dim>)
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(3, double)
#undef SLUICE_INSTANTIATE

}  // namespace sluice::SLUICE_ISA
