// The fluid's loops, compiled once per instruction set.
#include "kernels/passes/fluid_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

#define SLUICE_INSTANTIATE(Dim, Number)                    \
    SLUICE_INSTANTIATE_PASS(Number, InviscidMomentum<Dim>) \
    SLUICE_INSTANTIATE_PASS(Number, ViscousMomentum<Dim>)  \
    SLUICE_INSTANTIATE_PASS(Number, MorrisMomentum<Dim>)   \
    SLUICE_INSTANTIATE_PASS(Number, DensityRate<Dim>)      \
    SLUICE_INSTANTIATE_PASS(Number, FilterSums<Dim>)
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

}  // namespace sluice::SLUICE_ISA
