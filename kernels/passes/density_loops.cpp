// The loops of the fluid's density diffusion, compiled once per instruction set.
#include "kernels/passes/density_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

#define SLUICE_INSTANTIATE(Dim, Number)                                                  \
    SLUICE_INSTANTIATE_PASS(Number, DiffusiveDensityRate<Dim, StratifiedDiffusion<Dim>>) \
    SLUICE_INSTANTIATE_PASS(Number, DiffusiveDensityRate<Dim, GradientDiffusion>)        \
    SLUICE_INSTANTIATE_PASS(Number, DensityGradientSums<Dim>)
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

}  // namespace sluice::SLUICE_ISA
