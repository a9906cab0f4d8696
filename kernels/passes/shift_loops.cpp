// The loops of particle shifting, compiled once per instruction set.
#include "kernels/passes/shift_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

#define SLUICE_INSTANTIATE(Dim, Number)                      \
    SLUICE_INSTANTIATE_PASS(Number, FluidConcentration<Dim>) \
    SLUICE_INSTANTIATE_PASS(Number, SurfaceNormal<Dim>)
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

SLUICE_INSTANTIATE_PASS(double, BoundaryConcentration<2>)
SLUICE_INSTANTIATE_PASS(double, BoundaryConcentration<3>)

}  // namespace sluice::SLUICE_ISA
