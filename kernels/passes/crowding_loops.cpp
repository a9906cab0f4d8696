// The loop that finds particles too close to each other, compiled once per instruction set.
#include "kernels/passes/crowding_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

SLUICE_INSTANTIATE_PASS(double, Crowding<2>)
SLUICE_INSTANTIATE_PASS(double, Crowding<3>)

}  // namespace sluice::SLUICE_ISA
