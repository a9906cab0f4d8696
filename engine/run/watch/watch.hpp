// A run watches itself: what breaks it, what looks wrong, where, and what to do about it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/run/watch/warning.hpp"
#include "engine/simulation/simulation.hpp"

namespace sluice {

/// What can look wrong and yet be computed on.
enum class Suspicion {
    mach,      ///< the flow is faster than weak compressibility allows
    density,   ///< a fluid's density is far from its own
    crowding,  ///< fluid particles have come too close to each other
    entry,     ///< a fluid particle has entered a wall or a solid
    energy,    ///< there is more energy than there can be
    breakdown  ///< what would stop the run, had the scene not asked to go on
};
inline constexpr std::array<std::string_view, 6> suspicion_names{"mach",  "density", "crowding",
                                                                 "entry", "energy",  "breakdown"};

/// Looks at a simulation every few steps.
///
/// What breaks a run is thrown as a NumericalError, unless the scene's policy is to warn and numbers are finite: a
/// state that is not finite, faster than its medium's sound, half or twice as dense as at rest, or energy grown to ten
/// times what there was. What looks wrong is kept as a warning:
///   mach      |v|/c0 > method.mach_limit
///   density   |ρ/ρ0 − 1| > 10 × mach_limit²: pressures of the speed itself change it by Ma²/2
///   crowding  a hundredth of the fluid's particles nearer than 0.2 spacings to another: pairing, beyond the few that
///             meet in spray
///   entry     a fluid particle nearer than 0.35 spacings to a solid's: it is about to go through; or in a fixed wall,
///             behind its first layer
///   energy    grown by more than a twentieth of what there was at the start in motion, pressure and strain, and by
///             gravity down to the lowest particle. Not where walls or a driven acceleration do work
template <int Dim>
class Watch {
  public:
    explicit Watch(const Simulation<Dim>& initial);

    /// Throws NumericalError.
    void look(const Simulation<Dim>& simulation);
    /// Only for what breaks: cheap enough for before every output.
    void check(const Simulation<Dim>& simulation) const;

    std::uint64_t looks() const { return looks_; }
    /// Those that there were.
    std::vector<Warning> warnings() const;
    /// Messages that are new since the last call: one for each suspicion in a run.
    std::vector<std::string> take_news();

    /// visit(name, member) for what changes during a run.
    template <class Visit>
    void visit_state(Visit&& visit) {
        visit("looks", looks_);
        for (std::size_t k = 0; k < warnings_.size(); ++k) visit(suspicion_names[k], warnings_[k]);
    }

  private:
    void suspect(Suspicion what, double value, bool worse, double time, const std::string& message);
    void forgive(const Simulation<Dim>& simulation);
    void look_at_speed(const Simulation<Dim>& simulation);
    void look_at_density(const Simulation<Dim>& simulation);
    void look_at_crowds(const Simulation<Dim>& simulation);
    void look_at_walls(const Simulation<Dim>& simulation);
    void look_at_solids(const Simulation<Dim>& simulation);
    void look_at_energy(const Simulation<Dim>& simulation);

    bool forgiving_;           ///< the policy is to warn
    bool energy_is_closed_;    ///< nothing from outside does work
    double start_energy_ = 0;  ///< total [J; J/m in 2D]
    double available_ = 0;     ///< at the start, with all that gravity may give [J; J/m in 2D]
    std::uint64_t looks_ = 0;
    std::array<Warning, suspicion_names.size()> warnings_{};
    std::vector<std::string> news_;
};

extern template class Watch<2>;
extern template class Watch<3>;

}  // namespace sluice
