// An elastic solid in its reference configuration, total Lagrangian: its own steps within a step
// (kernels/passes/total_lagrangian_passes.hpp).
#pragma once

#include "engine/step/parts/clamp_extension.hpp"
#include "engine/step/parts/solid_part.hpp"
#include "kernels/passes/total_lagrangian_passes.hpp"

namespace sluice {

/// A step of its own goes by kick, drift and kick under stress, contact and gravity: symplectic, so that the energy
/// neither grows nor fades. Of the fluid's force only what is steady is in it (engine/step/parts/steady_load.hpp); the rest
/// comes before and after as an impulse.
template <int Dim>
class HyperelasticSolid final : public SolidPart<Dim> {
  public:
    explicit HyperelasticSolid(StepContext<Dim>& context);

    void start() override;
    void limit_step(std::vector<CourantLimit>& limits) const override;
    void begin_step() override;
    double move(int substep) override;
    void finish_move() override;
    void end_step() override;
    void last_kick() override;
    void add_energy(EnergyBalance& e) const override;
    Vec<Dim> momentum() const override;

  private:
    const PartRange& part() const { return c_.state.hyperelastic; }
    double dt() const { return c_.plan.dt / c_.plan.substeps; }
    const NeighborList& moving() const { return moving_ ? moving_->list : all_.list; }
    void kick();
    double drift();
    /// v += interval · (interface acceleration − steady acceleration); the steady part acts in move(). interval in s.
    void push(double interval);
    /// F and T where they may change, and the acceleration by stress and contact.
    void update_stress();
    /// F and T where they may change, and the acceleration by stress. Returns the pairs that it took.
    std::uint64_t elastic_forces(const ElasticViscosity& viscosity);
    /// The highest angular frequency of all its small motions about its reference configuration, at most 1 % too low; 0
    /// if nothing can move. [1/s] By some dozens of force evaluations.
    double find_fastest_mode();
    /// The highest rate at which artificial viscosity would damp a motion if it acted on all pairs. [1/s]
    double find_fastest_damping();
    /// ρ = ρ0/det F, which the fluid sees; at the most that of Hyperelastic::expansion_volume.
    void update_density();
    /// What the hourglass control holds. [J; J/m in 2D]
    double hourglass_energy() const;
    /// courant · 2/ω of the fastest mode, with artificial viscosity or contact less. [s]
    double stable_step() const;

    StepContext<Dim>& c_;
    Pairing& all_;                ///< without the rows of those whose stress never changes
    Pairing* moving_ = nullptr;  ///< the rows whose forces are asked for; null: all
    std::vector<Hyperelastic> laws_;  ///< one, or one for each body of the scene
    ElasticViscosity viscosity_;
    ClampExtension<Dim> behind_clamp_;
    double fastest_mode_ = 0, fastest_damping_ = 0;
};

extern template class HyperelasticSolid<2>;
extern template class HyperelasticSolid<3>;

}  // namespace sluice
