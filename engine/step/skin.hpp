// When a neighbour list must be rebuilt, and when it pays to prune it.
#pragma once

#include <algorithm>
#include <cmath>

namespace sluice {

/// Tracks how far particles have moved since a list was built with a skin, and since it was pruned.
class SkinAccount {
  public:
    SkinAccount(double skin, double smoothing_length) : skin_(skin), h_(smoothing_length) {}

    double skin() const { return skin_; }
    /// How far particles may have moved since the build. [m]
    double motion() const { return since_build_; }
    /// Reports that no particle has moved farther than this since the last call. [m]
    void add_motion(double distance) {
        since_build_ += distance;
        since_prune_ += distance;
        last_ = distance;
    }
    /// Estimates how far particles will move in the next step, before the first one. [m]
    void expect_motion(double distance) { last_ = distance; }
    /// Whether some pair might come within its support in the next step without being listed.
    bool outdated() const { return 2 * (since_build_ + next()) > skin_; }
    bool prune_due() const { return 2 * (since_prune_ + next()) > pruned_skin_; }

    void was_built() { since_build_ = 0; }
    /// Returns the skin to prune with now: it should last for some steps, but rows grow with it. A row of a pass costs
    /// about 1 + 2.5 s/h for a pruned skin s, a step has three passes, and pruning costs half a pass: with a motion u
    /// per step, the total is least if a prune lasts √(h/30u) steps.
    double prune() {
        const double left = std::max(skin_ - 2 * since_build_, 0.0);
        const double steps = next() > 0 ? std::clamp(std::round(std::sqrt(h_ / (30 * next()))), 1.0, 50.0) : 50.0;
        since_prune_ = 0;
        return pruned_skin_ = std::min(left, next() > 0 ? 2 * next() * steps : 0.05 * h_);
    }

    /// visit(name, member) for what changes during a run.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("since_build", since_build_), visit("since_prune", since_prune_), visit("pruned_skin", pruned_skin_);
        visit("last", last_);
    }

  private:
    /// Bound of the motion in the next step: a little more than in the last.
    double next() const { return 1.2 * last_; }

    double skin_, h_;
    double since_build_ = 0, since_prune_ = 0, pruned_skin_ = 0, last_ = 0;
};

}  // namespace sluice
