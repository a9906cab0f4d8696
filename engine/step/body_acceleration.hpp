// Gravity, and an acceleration of everything that depends on time: a tank that is shaken, seen from within.
#pragma once

#include <vector>

#include "engine/scene/formula.hpp"
#include "engine/step/context.hpp"

namespace sluice {

template <int Dim>
class BodyAcceleration {
  public:
    explicit BodyAcceleration(StepContext<Dim>& context) : c_(context), constant_(context.state.gravity) {
        if (!c_.has(Effect::driven_acceleration)) return;
        for (std::size_t k = 0; k < Dim; ++k)
            driven_.emplace_back(c_.scene, "acceleration", c_.scene.acceleration[k], Variable::time);
    }

    /// Sets the state's gravity to that of a time [s].
    void update(double t) {
        if (driven_.empty()) return;
        c_.state.gravity = constant_;
        for (int k = 0; k < Dim; ++k) c_.state.gravity[k] += driven_[static_cast<std::size_t>(k)](t);
    }

  private:
    StepContext<Dim>& c_;
    Vec<Dim> constant_;  ///< [m/s²]
    std::vector<CompiledFormula> driven_;
};

}  // namespace sluice
