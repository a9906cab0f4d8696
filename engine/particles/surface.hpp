// The moving surface of the solids: interface elements from the particles' positions. Elements tile a closed surface
// around each body, so Σ n ΔΓ over a body is zero to rounding however it deforms and a uniform pressure exerts no net
// force; around a box it is the box itself.
//
// In 2D the surface lies half a spacing outside the outer particles' centres. Each particle of the outline gives one
// vertex of a polygon, at x + (d/2) (n₁ + n₂)/(1 + n₁·n₂), where its two edges, shifted outwards by d/2, meet. Elements
// are the polygon's sides.
//
// In 3D each site of the initial lattice is a brick around its particle, and elements are the sides of bricks that no
// other brick covers: quadrilaterals between corners of the lattice. They enclose the particles' volumes, cavities have
// a surface of their own, and nothing has to be known of the shape.
//
// Place of a corner. The motion around the corner's initial place X_v is fitted by x(X) = b + B (X − X_v): the minimum
// of Σ_a g_a |x_a − b − B (X_a − X_v)|² over the particles a around it, with weights g_a that fall with their initial
// distance. The corner is put at b. The normal equations give it as a sum with fixed weights,
//   x_v = Σ_a w_va x_a,   w_va = g_a p_a·M⁻¹p_v,   M = Σ_a g_a p_a p_aᵀ,   p_a = (1, X_a − X_v),   p_v = (1, 0, 0, 0),
// that depend on the initial lattice alone: Σ_a w_va = 1 and Σ_a w_va X_a = X_v (Σ_a w_va p_a = M M⁻¹ p_v). So a corner
// follows translation, rotation and every other affine deformation to rounding. In the flat side of a body the weights
// of the outer layer add up to 1.5 and those of the next one to −0.5.
//
// Accuracy. Of a smooth deformation a corner misses ½ Σ_a w_va (X_a − X_v)·∇∇x (X_a − X_v) = O(d²). Along a side of the
// body the weights are the same from corner to corner, so that this error is itself smooth, and neighbouring corners
// differ in it by O(d³): the edges between them, and the element's area and normal, are right to a relative O(d²).
// Along edges of the body, where the weights change, it is O(d) in a share O(d) of the elements.
//
// Area. Any surface within a closed loop of corners has the area vector ½ Σ_c x_c × x_(c+1); for four corners that is
//   n ΔΓ = ½ (x_2 − x_0) × (x_3 − x_1).
// In the sum over a closed surface each edge is run through once in either direction, by the two faces that meet there,
// so everything cancels. At an edge that two bricks share without a brick between them four faces meet; there each
// brick has its own corners (unless they are one place because the bricks are connected around it), and its own two
// faces cancel.
#pragma once

#include <array>
#include <vector>

#include "engine/geometry/packing.hpp"
#include "engine/particles/id_index.hpp"
#include "engine/particles/particle_set.hpp"

namespace sluice {

/// The surface of all solid bodies. In both dimensions:
///   add_body(packing, first_id, body)   a body whose particles have the ids first_id, first_id + 1, … in the packing's
///                                       order
///   element_count(), bytes()
///   allocate(elements)                  sizes the columns and sets what does not change
///   update(position, index_of_id, elements)   place and area normal of every element from the solid's positions;
///                                       `index_of_id` finds a particle. Allocates nothing.
template <int Dim>
class BodySurface;

template <>
class BodySurface<2> {
  public:
    void add_body(const Packing& packing, Index first_id, std::uint16_t body);
    std::size_t element_count() const;
    std::size_t bytes() const;
    void allocate(ParticleSet<2>& elements) const;
    void update(const VectorField<2>& position, const IdIndex& index_of_id, ParticleSet<2>& elements);

  private:
    struct Chain {
        std::vector<Index> ids;
        double half_spacing;  ///< d/2 [m]
        std::uint16_t body;
    };
    std::vector<Chain> chains_;
};

template <>
class BodySurface<3> {
  public:
    void add_body(const Packing& packing, Index first_id, std::uint16_t body);
    std::size_t element_count() const { return faces_.size(); }
    std::size_t bytes() const;
    void allocate(ParticleSet<3>& elements) const;
    void update(const VectorField<3>& position, const IdIndex& index_of_id, ParticleSet<3>& elements);

  private:
    struct Face {
        std::array<Index, 4> corners;
        std::uint16_t body;
    };
    struct Share {
        Index id;
        double weight;
    };
    std::vector<Face> faces_;
    std::vector<Share> shares_;                ///< of all corners, one corner after the other
    std::vector<std::size_t> first_share_{0};  ///< of each corner; one more at the end
    VectorField<3> corner_;                    ///< places, as of the last update [m]
};

}  // namespace sluice
