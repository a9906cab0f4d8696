// How far a step goes: Courant limits, and each medium's share of a step.
#pragma once

#include <string>
#include <vector>

namespace sluice {

struct Scene;
template <int Dim>
struct State;

/// The largest stable step of one medium.
struct CourantLimit {
    std::string medium;  ///< material's name
    double dt = 0;       ///< courant · h / c0 [s]
};

/// Those of the media present, the fluid's first, each with its smallest h.
template <int Dim>
std::vector<CourantLimit> courant_limits_of(const Scene& scene, const State<Dim>& state);

/// The step of all media together, and how many sub-steps of the solid there are in it.
struct StepPlan {
    double dt = 0;                 ///< [s]
    int substeps = 1;              ///< of the solid
    double single_rate_steps = 1;  ///< how many steps of the single-rate scheme it takes the place of
};

/// Single-rate: the smallest limit for all. Multi-rate: the fluid's limit, cut into as many solid steps as the solid's
/// limit asks for. A step that the scene sets is taken as it is, and cut likewise.
StepPlan plan_steps(const Scene& scene, const std::vector<CourantLimit>& limits, bool both_media);

}  // namespace sluice
