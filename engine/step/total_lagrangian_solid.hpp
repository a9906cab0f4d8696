// An elastic solid in its reference configuration: its own steps within a step (kernels/total_lagrangian_passes.hpp).
#pragma once

#include "engine/step/contact.hpp"
#include "engine/step/context.hpp"
#include "kernels/total_lagrangian_passes.hpp"

namespace sluice {

template <int Dim>
class TotalLagrangianSolid {
  public:
    TotalLagrangianSolid(StepContext<Dim>& context, SolidContact<Dim>& contact);

    /// Goes through a step by kick, drift and kick, under the fluid's force of its beginning: symplectic, so that the
    /// energy neither grows nor fades. Returns a bound of how far particles have moved. [m]
    double advance();

    /// v += the fluid's force · interval [s]
    void push(double interval);
    /// What the hourglass control holds. [J; J/m in 2D]
    double hourglass_energy() const;

  private:
    double dt() const { return c_.plan.dt / c_.plan.substeps; }
    void kick();
    double drift();
    /// Its own steps. Returns as advance().
    double move();
    /// F and T where they may change, the acceleration by stress of those listed, and that by contact.
    void update_stress(const NeighborList& accelerated);
    /// ρ = ρ0/det F, which the fluid sees.
    void update_density();

    StepContext<Dim>& c_;
    SolidContact<Dim>& contact_;
    Hyperelastic law_;
    ElasticViscosity viscosity_;
};

extern template class TotalLagrangianSolid<2>;
extern template class TotalLagrangianSolid<3>;

}  // namespace sluice
