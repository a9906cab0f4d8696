// Contact of solids with each other and with walls (kernels/passes/contact_passes.hpp), within the solid's own steps.
#pragma once

#include "engine/step/context.hpp"
#include "engine/step/coupling.hpp"
#include "engine/step/couplings/contact_search.hpp"
#include "kernels/passes/contact_passes.hpp"

namespace sluice {

/// k over the modulus λ + 2μ of the fastest waves. Bodies that meet at a relative speed v press with ½ ρ c v, c their
/// fastest waves', so that at 1 they come closer than touching by about v/c · d/(4 σ_0'²), 1.4 v/c spacings at h/d =
/// 1.5, and contact is no faster than the lattice itself: two pressed blocks' fastest mode is 1 to 4 % faster than
/// theirs alone (eigenvalues in 2D, h/d from 1.2 to 2, cubic spline and Wendland C2, a tenth and half of a spacing
/// closer than touching), so steps are stable up to 0.92 h/c instead of 0.94 at the worst. At 2 it would be 6 to 15 %.
inline constexpr double contact_stiffness = 1;

/// Total-Lagrangian solids meet each other, unless they are joined (engine/particles/joined_bodies.hpp); any solid
/// meets walls. A particle that starts closer than touching uses its initial σ, or its distance from a plane, as
/// threshold, so the initial force is zero. A particle that starts behind a mirror plane never feels it. Moving walls
/// push too; as they take whole steps, the solid's own steps see them where they were at the end of the last one.
template <int Dim>
class SolidContact final : public Coupling<Dim> {
  public:
    explicit SolidContact(StepContext<Dim>& context);

    void start() override;
    /// Notes that walls have moved.
    void rates() override { search_.add_motion(c_.motion.wall); }
    void solid_has_moved(double distance) override { search_.add_motion(distance); }
    void push_solid(const PartRange& part) override;

    // As of the last push_solid():
    void add_energy(EnergyBalance& e) const override { e.contact += energy(); }
    Vec<Dim> contact_force_on(std::size_t body) const override;
    std::uint64_t builds() const override { return search_.builds(); }
    std::size_t bytes() const override;
    void save(const StateWriter& writer) override;
    void restore(const StateReader& reader) override;

  private:
    using Particles = ContactParticles<Dim>;

    void set_thresholds();
    /// Moves copies to their particles, and sets their σ and force to zero.
    void refresh(Particles& p);
    using Bodies = BodyContact<Dim>;

    void sum_among_bodies(Bodies& contact);
    void sum_at_walls();
    void push_among_bodies(std::size_t contact, const PartRange& part);
    void push_at_walls(const PartRange& part);
    void push_at_planes(const PartRange& part);
    double energy() const;  ///< [J; J/m in 2D]
    /// p = k (σ − threshold)₊ with k = stiffness(i). Returns whether there is any pressure.
    template <class Stiffness>
    bool set_pressure(Particles& p, const ScalarField& threshold, Stiffness&& stiffness);
    /// The k of a solid particle against walls. [Pa]
    double wall_stiffness(std::size_t i) const;
    /// Adds the forces on copies to the acceleration of their particles in this range.
    void accelerate(const Particles& p, const PartRange& part);
    /// (z_0 − z)₊ of a particle. [m]
    double depth(std::size_t plane, std::size_t i) const;
    /// The force on a particle over (z_0 − z)₊. [N/m; N/m² in 2D]
    double plane_stiffness(std::size_t i) const;

    StepContext<Dim>& c_;
    ContactSearch<Dim> search_;
    FlatContact flat_;
    std::vector<ScalarField> body_threshold_;   ///< of σ for each of the search's contacts, by id
    ScalarField wall_threshold_;                ///< of σ, by id
    std::vector<ScalarField> plane_threshold_;  ///< z_0 for each plane, by id [m]
};

extern template class SolidContact<2>;
extern template class SolidContact<3>;

}  // namespace sluice
