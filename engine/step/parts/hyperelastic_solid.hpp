// The total-Lagrangian solid (kernels/passes/total_lagrangian_passes.hpp), with steps of its own within a step.
#pragma once

#include "engine/step/parts/clamp_extension.hpp"
#include "engine/step/parts/solid_part.hpp"
#include "kernels/passes/total_lagrangian_passes.hpp"

namespace sluice {

/// A step of its own is kick, drift, kick under stress, contact and gravity: symplectic, so that energy neither grows
/// nor decays. It includes only the steady part of the fluid's force (engine/step/parts/steady_load.hpp); the rest acts
/// as an impulse before and after all of them.
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
    /// Computes F and T where they may change, and the acceleration by stress and contact.
    void update_stress();
    /// Computes F and T where they may change, and the acceleration by stress. Returns the number of pairs.
    std::uint64_t elastic_forces(const ElasticViscosity& viscosity);
    /// The highest angular frequency of small motions about the reference configuration, at most 1 % too low; 0 if
    /// nothing can move. [1/s] Takes some dozens of force evaluations.
    double find_fastest_mode();
    /// The highest rate at which artificial viscosity, acting on all pairs, would damp a motion. [1/s]
    double find_fastest_damping();
    /// Sets the density that the fluid sees, ρ0/det F; at most that at Hyperelastic::expansion_volume.
    void update_density();
    /// The energy of the hourglass control. [J; J/m in 2D]
    double hourglass_energy() const;
    /// courant · 2/ω of the fastest mode, less with artificial viscosity or contact. [s]
    double stable_step() const;

    StepContext<Dim>& c_;
    Pairing& all_;                    ///< without the rows of particles whose stress never changes
    Pairing* moving_ = nullptr;       ///< the rows whose forces are needed; null: all
    std::vector<Hyperelastic> laws_;  ///< one, or one for each body of the scene
    ElasticViscosity viscosity_;
    ClampExtension<Dim> behind_clamp_;
    double fastest_mode_ = 0, fastest_damping_ = 0;
};

extern template class HyperelasticSolid<2>;
extern template class HyperelasticSolid<3>;

}  // namespace sluice
