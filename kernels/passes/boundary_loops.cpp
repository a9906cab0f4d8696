// The loops between fluid and moving boundary, compiled once per instruction set.
#include "kernels/passes/boundary_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

#define SLUICE_INSTANTIATE(Dim)                                        \
    SLUICE_INSTANTIATE_PASS(double, BoundaryPressure<Dim>)             \
    SLUICE_INSTANTIATE_PASS(double, BoundaryReaction<Dim>)             \
    SLUICE_INSTANTIATE_PASS(double, BoundaryContinuity<Dim>)           \
    SLUICE_INSTANTIATE_PASS(double, BoundaryFrictionPass<Dim>)         \
    SLUICE_INSTANTIATE_PASS(double, BoundaryFrictionReactionPass<Dim>) \
    SLUICE_INSTANTIATE_PASS(double, BoundaryVelocitySums<Dim>)
SLUICE_INSTANTIATE(2)
SLUICE_INSTANTIATE(3)
#undef SLUICE_INSTANTIATE

}  // namespace sluice::SLUICE_ISA
