// The paper's hypoelastic solid, in the deformed configuration, with steps of its own within a step.
#pragma once

#include "engine/step/parts/solid_part.hpp"
#include "kernels/passes/solid_passes.hpp"

namespace sluice {

/// A step of its own is one of the paper's staggered explicit Euler scheme: velocities at n ± 1/2, everything else at
/// n; rates of density and stress are computed half-way.
template <int Dim>
class HypoelasticSolid final : public SolidPart<Dim> {
  public:
    explicit HypoelasticSolid(StepContext<Dim>& context);

    void start() override;
    void limit_step(std::vector<CourantLimit>& limits) const override;
    void begin_step() override;
    double move(int substep) override;
    void end_step() override;
    void add_energy(EnergyBalance& e) const override;
    Vec<Dim> momentum() const override;
    void save(const StateWriter& writer) override;
    void restore(const StateReader& reader) override;

  private:
    const PartRange& part() const { return c_.state.hypoelastic; }
    double dt() const { return c_.plan.dt / c_.plan.substeps; }
    /// The rows whose forces are needed.
    const NeighborList& moving() const { return moving_ ? moving_->list : all_.list; }
    void forces();
    void kick();
    void filter();
    void drift_halfway();
    void rates_halfway();
    double drift_to_end();

    StepContext<Dim>& c_;
    Pairing& all_;               ///< without the rows of particles whose stress never changes
    Pairing* moving_ = nullptr;  ///< null: all are moving
    SolidTerms terms_;
    double last_dt_ = 0;  ///< of its previous step, half of which the velocities are behind; 0 at the start
};

extern template class HypoelasticSolid<2>;
extern template class HypoelasticSolid<3>;

}  // namespace sluice
