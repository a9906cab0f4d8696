// The length of a step: Courant limits, and the number of the solid's sub-steps.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/effects/set_id.hpp"

namespace sluice {

struct Scene;
class Effects;

/// The largest stable step of one material.
struct CourantLimit {
    SetId set{};             ///< fluid or solid
    std::string medium;      ///< material's name
    double dt = 0;           ///< courant · h / c0, or the limit by viscosity or by the fastest mode [s]
    double h = 0;            ///< the medium's smallest smoothing length [m]
    double sound_speed = 0;  ///< c0 [m/s]
    double viscosity = 0;    ///< ν [m²/s]
};

/// The step of all media, and the number of the solid's sub-steps in it.
struct StepPlan {
    double dt = 0;                 ///< [s]
    int substeps = 1;              ///< of the solid
    double single_rate_steps = 1;  ///< how many steps of the single-rate scheme it replaces

    /// visit(name, member) for each member.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("dt", dt), visit("substeps", substeps), visit("single_rate_steps", single_rate_steps);
    }
};

/// Plans each step before it is taken.
///
/// Single-rate: the smallest limit for all. Multi-rate: the fluid's limit, divided into as many solid steps as the
/// solid's limit requires. A step that the scene states is taken as it is, and divided likewise.
///
/// A viscous fluid allows no more than ⅛ h²/ν [Morris, Fox & Zhu 1997].
///
/// Adaptive: the fluid's limit is courant · h/(c0 + |v|) and ¼ √(h/|a|) [Monaghan 1992], the smaller, from the highest
/// speed and acceleration of the last step; from one step to the next it grows by a tenth at the most.
class StepPlanner {
  public:
    /// Throws SceneError if no run could finish with such steps.
    StepPlanner(const Scene& scene, const Effects& effects, std::vector<CourantLimit> limits);

    /// speed, acceleration: the highest of the fluid [m/s, m/s²]
    StepPlan next(double speed, double acceleration);
    /// Multiplies later steps by this.
    void set_share(double share) { share_ = share, uneven_ = uneven_ || share != 1; }
    /// Whether steps may differ in length.
    bool adaptive() const { return adaptive_ || uneven_; }
    /// The limits of all materials, fluids first.
    const std::vector<CourantLimit>& limits() const { return limits_; }

    /// visit(name, member) for what changes during a run.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("last", last_), visit("share", share_), visit("uneven", uneven_);
    }

  private:
    /// The smallest limit of a set; of all sets if it has none.
    double smallest_limit(SetId set) const;
    bool has(SetId set) const;
    void check(const Scene& scene) const;

    std::vector<CourantLimit> limits_;
    bool adaptive_, multi_rate_;
    double stated_ = 0;  ///< the scene's own step; 0 = none [s]
    double last_ = 0;    ///< [s]
    double share_ = 1;   ///< factor on the steps (set_share)
    bool uneven_ = false;
};

}  // namespace sluice
