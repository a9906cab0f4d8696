// The moving surface of the solids: interface elements from the boundary particles' positions.
#pragma once

#include <vector>

#include "engine/geometry/packing.hpp"
#include "engine/state/phases.hpp"

namespace sluice {

/// The boundary particles of all solid bodies, as closed chains in the plane.
///
/// The interface lies half a spacing outside the outer particles' centres. Each particle of a chain gives one vertex of
/// a polygon: at x + (d/2) (n₁ + n₂)/(1 + n₁·n₂), where its two edges, shifted outwards by d/2, meet. Elements are the
/// polygon's sides: Σ n ΔΓ over a body is zero to rounding however it deforms, so a uniform pressure exerts no net
/// force, and a box's polygon is the box itself.
class SurfaceChains {
  public:
    /// Adds a body whose particles have the ids first_id, first_id + 1, … in the packing's order.
    void add_body(const Packing& packing, Index first_id, std::uint16_t body);

    std::size_t element_count() const;
    bool empty() const { return chains_.empty(); }

    /// Position and area normal of every element, from the solid's positions. `index_of_id` finds a particle.
    void update(const VectorField<2>& position, const std::vector<Index>& index_of_id,
                InterfaceElements<2>& elements) const;
    /// Sizes the columns and sets what does not change.
    void allocate(InterfaceElements<2>& elements) const;

  private:
    struct Chain {
        std::vector<Index> ids;
        double half_spacing;  ///< d/2 [m]
        std::uint16_t body;
    };
    std::vector<Chain> chains_;
};

}  // namespace sluice
