// How a wall of the scene moves.
#pragma once

#include <vector>

#include "engine/scene/formula.hpp"
#include "engine/scene/scene.hpp"
#include "neighbor/vec.hpp"

namespace sluice {

/// A wall's displacement over time, by its formulas or its table. Before a table's first row and after its last the
/// wall rests.
template <int Dim>
class WallMotion {
  public:
    WallMotion(const Scene& scene, const Wall& wall);

    /// [m]
    Vec<Dim> displacement(double t) const;

  private:
    const Motion& motion_;
    std::vector<CompiledFormula> formulas_;
};

extern template class WallMotion<2>;
extern template class WallMotion<3>;

}  // namespace sluice
