// The solid of the paper, hypoelastic and updated-Lagrangian: its own steps within a step.
#pragma once

#include "engine/step/contact.hpp"
#include "engine/step/context.hpp"
#include "kernels/passes/solid_passes.hpp"

namespace sluice {

template <int Dim>
class HypoelasticSolid {
  public:
    HypoelasticSolid(StepContext<Dim>& context, SolidContact<Dim>& contact);

    /// Goes through a step by the staggered explicit Euler scheme of the paper: velocities at n ± 1/2, everything else
    /// at n; rates of density and stress are taken half-way. Returns a bound of how far particles have moved. [m]
    double advance();

    /// visit(name, member) for what changes during a run and is not among the particles' columns.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("last_dt", last_dt_);
    }

  private:
    double dt() const { return c_.plan.dt / c_.plan.substeps; }
    void forces();
    void kick();
    void filter();
    void drift_halfway();
    void rates_halfway();
    double finish();

    StepContext<Dim>& c_;
    SolidContact<Dim>& contact_;
    SolidTerms terms_;
    double last_dt_ = 0;  ///< of the sub-step before: velocities stand half of it behind; at first they stand at 0
};

extern template class HypoelasticSolid<2>;
extern template class HypoelasticSolid<3>;

}  // namespace sluice
