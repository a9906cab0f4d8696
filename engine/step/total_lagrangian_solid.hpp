// An elastic solid in its reference configuration: its own steps within a step (kernels/passes/total_lagrangian_passes.hpp).
#pragma once

#include "engine/step/clamp_extension.hpp"
#include "engine/step/contact.hpp"
#include "engine/step/context.hpp"
#include "kernels/passes/total_lagrangian_passes.hpp"

namespace sluice {

template <int Dim>
class TotalLagrangianSolid {
  public:
    TotalLagrangianSolid(StepContext<Dim>& context, SolidContact<Dim>& contact);

    /// Goes through a step by kick, drift and kick under stress, contact and gravity: symplectic, so that the energy
    /// neither grows nor fades. Of the fluid's force only what is steady is in it (engine/step/steady_load.hpp); the
    /// rest comes before and after as an impulse (push).
    /// Returns a bound of how far particles have moved. [m]
    double advance();

    /// v += what of the fluid's force does not act in advance() · interval [s]
    void push(double interval);
    /// What the hourglass control holds. [J; J/m in 2D]
    double hourglass_energy() const;
    /// The highest angular frequency of all its small motions about its reference configuration, at most 1 % too low; 0
    /// if nothing can move. [1/s]
    double fastest_mode() const { return fastest_mode_; }
    /// The highest rate at which artificial viscosity would damp a motion if it acted on all pairs; 0 with so little of
    /// it that it does not matter. [1/s]
    double fastest_damping() const { return fastest_damping_; }

  private:
    double dt() const { return c_.plan.dt / c_.plan.substeps; }
    void kick();
    double drift();
    /// Its own steps. Returns as advance().
    double move();
    /// F and T where they may change, and the acceleration by stress and contact.
    void update_stress();
    /// F and T where they may change, and the acceleration by stress. Returns the pairs that it took.
    std::uint64_t elastic_forces(const ElasticViscosity& viscosity);
    /// By some dozens of force evaluations.
    double find_fastest_mode();
    double find_fastest_damping();
    /// ρ = ρ0/det F, which the fluid sees; at the most that of Hyperelastic::expansion_volume.
    void update_density();

    StepContext<Dim>& c_;
    SolidContact<Dim>& contact_;
    Hyperelastic law_;
    ElasticViscosity viscosity_;
    ClampExtension<Dim> behind_clamp_;
    double fastest_mode_ = 0, fastest_damping_ = 0;
};

extern template class TotalLagrangianSolid<2>;
extern template class TotalLagrangianSolid<3>;

}  // namespace sluice
