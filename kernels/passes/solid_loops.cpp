// The solid's loops, compiled once per instruction set.
#include "kernels/passes/solid_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

#define SLUICE_INSTANTIATE(Dim, Number)                                                           \
    SLUICE_INSTANTIATE_PASS(Number, StressDivergence<Dim>)                                        \
    SLUICE_INSTANTIATE_PASS(Number, StressDivergence<Dim, ArtificialViscosity>)                   \
    SLUICE_INSTANTIATE_PASS(Number, StressDivergence<Dim, ArtificialStress>)                      \
    SLUICE_INSTANTIATE_PASS(Number, StressDivergence<Dim, ArtificialViscosity, ArtificialStress>) \
    SLUICE_INSTANTIATE_PASS(Number, SolidRateSums<Dim>)
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

}  // namespace sluice::SLUICE_ISA
