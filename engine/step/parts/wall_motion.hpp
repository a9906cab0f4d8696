// The prescribed motion of a wall.
#pragma once

#include <vector>

#include "engine/scene/formula.hpp"
#include "engine/scene/scene.hpp"
#include "neighbor/vec.hpp"

namespace sluice {

/// The displacement of a wall over time, by its formulas or its table. The wall rests before the first row of a table
/// and after the last.
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
