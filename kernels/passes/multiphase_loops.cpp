// The loops over pairs of different materials, compiled once per instruction set.
#include "kernels/passes/multiphase_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

#define SLUICE_INSTANTIATE(Dim, Number)                              \
    SLUICE_INSTANTIATE_PASS(Number, MultiphaseMomentum<Dim>)         \
    SLUICE_INSTANTIATE_PASS(Number, MultiphaseMorrisMomentum<Dim>)   \
    SLUICE_INSTANTIATE_PASS(Number, MultiphaseDensityRate<Dim>)      \
    SLUICE_INSTANTIATE_PASS(Number, MultiphaseStressDivergence<Dim>) \
    SLUICE_INSTANTIATE_PASS(Number, MultiphaseStressDivergence<Dim, ArtificialStress>)
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(2, float)
SLUICE_INSTANTIATE(3, double)
SLUICE_INSTANTIATE(3, float)
#undef SLUICE_INSTANTIATE

SLUICE_INSTANTIATE_PASS(double, MultiphaseElasticMomentum<2>)
SLUICE_INSTANTIATE_PASS(double, MultiphaseElasticMomentum<3>)

}  // namespace sluice::SLUICE_ISA
