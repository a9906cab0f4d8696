// Operations of a pass, as profiles count them, against counts by hand.
#include "kernels/pairs/block_loop.hpp"
#include "kernels/passes/crowding_loops.hpp"
#include "kernels/passes/fluid_loops.hpp"
#include "tests/catch.hpp"

using namespace sluice;

TEST_CASE("operations are those of the formula") {
    // x_ij: 2; r² and what keeps it off zero: 2 · 2; q² = r²/h²: 1; 1 − q²/c²: 2; the larger: 1; the sum: 1.
    CHECK(counted::operations_per_lane<Crowding<2>>() == 11);
    // One more component: a difference, a square and its addition.
    CHECK(counted::operations_per_lane<Crowding<3>>() == 14);
}

TEST_CASE("a loop over two formulas computes only once what both need") {
    const double momentum = counted::operations_per_lane<ViscousMomentum<2>>();
    const double continuity = counted::operations_per_lane<DensityRate<2>>();
    const double both = counted::operations_per_lane<FluidRates<2>>();
    CHECK(both > momentum);
    CHECK(both < momentum + continuity);
}

TEST_CASE("an operation is counted anew each time it is asked for") {
    const double once = counted::operations_per_lane<DensityRate<3>>();
    CHECK(once > 0);
    CHECK(counted::operations_per_lane<DensityRate<3>>() == once);
}
