// The loops of contact between solids, compiled once per instruction set.
#include "kernels/passes/contact_loops.hpp"

#include "kernels/pairs/block_loop_body.hpp"

namespace sluice::SLUICE_ISA {

SLUICE_INSTANTIATE_PASS(double, ContactSums<2>)
SLUICE_INSTANTIATE_PASS(double, ContactSums<3>)
SLUICE_INSTANTIATE_PASS(double, ContactForce<2>)
SLUICE_INSTANTIATE_PASS(double, ContactForce<3>)

}  // namespace sluice::SLUICE_ISA
