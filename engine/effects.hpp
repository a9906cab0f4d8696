// Which effects a scene calls for, and why: one table from which loops, allocation, output and messages follow.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.hpp"

namespace sluice {

enum class Effect {
    fluid_pressure,
    fluid_viscosity,
    velocity_filter,
    solid_stress,
    solid_viscosity,
    artificial_stress,
    solid_filter,
    interface_force,
    mirror_wall,
    fixed_wall,
    clamp,
    gravity,
    variable_resolution,
};
inline constexpr std::size_t effect_count = 13;

/// One row of the table.
struct EffectInfo {
    Effect effect;
    std::string_view name;      ///< in the field's standard terms
    std::string_view equation;  ///< source
};

/// The decision for one effect in one scene.
struct EffectChoice {
    EffectInfo info;
    bool on = false;
    std::string why;
};

class Effects {
  public:
    explicit Effects(const Scene& scene);
    bool has(Effect e) const { return choices_[static_cast<std::size_t>(e)].on; }
    const std::array<EffectChoice, effect_count>& all() const { return choices_; }

  private:
    std::array<EffectChoice, effect_count> choices_;
};

}  // namespace sluice
