// The loops of an elastic solid in its reference configuration, compiled once per instruction set.
#include "kernels/passes/total_lagrangian_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

#define SLUICE_INSTANTIATE(Dim, Number)                                       \
    SLUICE_INSTANTIATE_PASS(Number, GradientMatrixSums<Dim>)                  \
    SLUICE_INSTANTIATE_PASS(Number, DeformationSums<Dim>)                     \
    SLUICE_INSTANTIATE_PASS(Number, ElasticMomentum<Dim>)                     \
    SLUICE_INSTANTIATE_PASS(Number, ElasticMomentum<Dim, ReferenceViscosity>) \
    SLUICE_INSTANTIATE_PASS(Number, HourglassErrors<Dim>)
SLUICE_INSTANTIATE(2, double)
SLUICE_INSTANTIATE(3, double)
#undef SLUICE_INSTANTIATE

}  // namespace sluice::SLUICE_ISA
