// The loops between fluid and fixed ghosts, compiled once per instruction set.
#include "kernels/passes/wall_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

#define SLUICE_INSTANTIATE(Dim, Number)                     \
    SLUICE_INSTANTIATE_PASS(Number, GhostPressure<Dim>)     \
    SLUICE_INSTANTIATE_PASS(Number, GhostContinuity<Dim>)   \
    SLUICE_INSTANTIATE_PASS(Number, GhostPressureSums<Dim>) \
    SLUICE_INSTANTIATE_PASS(Number, MovingGhostPressureSums<Dim>)
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

}  // namespace sluice::SLUICE_ISA
