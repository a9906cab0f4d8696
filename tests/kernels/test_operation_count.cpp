// Operations of a pass, as profiles count them, against counts by hand.
#include "kernels/pairs/block_loop.hpp"
#include "kernels/passes/crowding_loops.hpp"
#include "kernels/passes/density_loops.hpp"
#include "kernels/passes/fluid_loops.hpp"
#include "tests/catch.hpp"

namespace sluice::test_operation_count {

TEST_CASE("operations are those of the formula") {
    // x_ij: 2; r² and what keeps it off zero: 2 · 2; q² = r²/h²: 1; 1 − q²/c²: 2; the larger: 1; the sum: 1.
    CHECK(counted::operations_per_lane<Crowding<2>>() == 11);
    // One more component: a difference, a square and its addition.
    CHECK(counted::operations_per_lane<Crowding<3>>() == 14);
}

TEST_CASE("a loop over two formulas computes only once what both need") {
    // Beside continuity's, of which x_ij and m ∇W/x serve diffusion too: ρ_i − ρ_j: 1; less G·x_ij: 2 · 2; 1/ρ_j: 4; its
    // product with 2 δ c0 h and with the difference: 2; the sum of both: 1.
    CHECK(counted::operations_per_lane<DiffusiveDensityRate<2, StratifiedDiffusion<2>>>() ==
          counted::operations_per_lane<DensityRate<2>>() + 12);
    // One more component: a product and a difference.
    CHECK(counted::operations_per_lane<DiffusiveDensityRate<3, StratifiedDiffusion<3>>>() ==
          counted::operations_per_lane<DensityRate<3>>() + 14);
}

TEST_CASE("an operation is counted anew each time it is asked for") {
    const double once = counted::operations_per_lane<DensityRate<3>>();
    CHECK(once > 0);
    CHECK(counted::operations_per_lane<DensityRate<3>>() == once);
}

}  // namespace sluice::test_operation_count
