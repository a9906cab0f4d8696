// Which effects a scene calls for, and why: loops, allocation, output and messages follow from one table
// (engine/effect_table.cpp).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/effects/names/set_id.hpp"
#include "engine/scene/scene.hpp"
#include "kernels/columns/column_table.hpp"

namespace sluice {

enum class Effect {
    fluid_pressure,
    artificial_viscosity,
    laminar_viscosity,
    acoustic_damping,
    density_diffusion,
    excess_density,
    density_gradient,
    particle_shifting,
    velocity_filter,
    several_fluids,
    solid_stress,
    total_lagrangian,
    hourglass_control,
    solid_viscosity,
    artificial_stress,
    solid_filter,
    several_solids,
    contact,
    interface_force,
    moving_boundary,
    mirror_wall,
    fixed_wall,
    no_slip_wall,
    no_slip_solid,
    moving_wall,
    periodic_box,
    clamp,
    clamp_extension,
    gravity,
    driven_acceleration,
    variable_resolution,
    adaptive_step,
    solid_substeps,
    steady_load,
};
inline constexpr std::size_t effect_count = 34;

/// One row of the table.
struct EffectInfo {
    Effect effect;
    std::string_view key;        ///< in [effects] and summary.json
    std::string_view name;       ///< in the field's standard terms
    std::string_view equation;   ///< source
    std::string_view fields;     ///< columns that it needs, as "phase.column phase.column"
    std::string_view automatic;  ///< the rule for "auto" in words: "on if ..."
    std::string_view formula;    ///< in a line; symbols as in the headers of kernels/terms/
    /// Where in a step its terms run: "PHASE/LOOP, PHASE/LOOP" (step_phase_names, pass_name); PHASE/* is all that runs
    /// in a phase, PHASE what of it is no loop over pairs. Empty: nowhere apart from others.
    std::string_view places = {};

    bool needs(SetId set, Column column) const;
};

/// The decision for one effect in one scene.
struct EffectChoice {
    EffectInfo info;
    bool on = false;
    std::string why;
};

class Effects {
  public:
    /// Throws SceneError where [effects] asks for what cannot be.
    explicit Effects(const Scene& scene);
    bool has(Effect e) const { return choices_[static_cast<std::size_t>(e)].on; }
    const std::array<EffectChoice, effect_count>& all() const { return choices_; }
    /// Whether an effect that is on needs this column of this set.
    bool needs(SetId set, Column column) const;

  private:
    std::array<EffectChoice, effect_count> choices_;
};

}  // namespace sluice
