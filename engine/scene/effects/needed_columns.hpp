// Columns that effects need, set by set, and the long lists of them.
#pragma once

#include <array>
#include <cstddef>

#include "engine/scene/effects/set_id.hpp"
#include "kernels/columns/column_table.hpp"

namespace sluice {

/// Some of the columns of each set.
struct NeededColumns {
    std::array<ColumnSet, all_sets.size()> of{};

    constexpr bool has(SetId set, Column column) const { return of[static_cast<std::size_t>(set)].has(column); }
    constexpr bool none() const { return *this == NeededColumns{}; }
    friend constexpr bool operator==(const NeededColumns&, const NeededColumns&) = default;
    friend constexpr NeededColumns operator|(NeededColumns a, const NeededColumns& b) {
        for (std::size_t set = 0; set < a.of.size(); ++set) a.of[set] = a.of[set] | b.of[set];
        return a;
    }
};

/// The words of which effects.def says what an effect needs: fluid(density, pressure) | wall(volume).
namespace needed {

using enum Column;

template <SetId Set>
constexpr NeededColumns columns_of(auto... columns) {
    NeededColumns needed;
    needed.of[static_cast<std::size_t>(Set)] = (ColumnSet() | ... | ColumnSet(columns));
    return needed;
}
constexpr NeededColumns fluid(auto... columns) { return columns_of<SetId::fluid>(columns...); }
constexpr NeededColumns solid(auto... columns) { return columns_of<SetId::solid>(columns...); }
constexpr NeededColumns wall(auto... columns) { return columns_of<SetId::wall>(columns...); }
constexpr NeededColumns elements(auto... columns) { return columns_of<SetId::elements>(columns...); }
constexpr NeededColumns boundary(auto... columns) { return columns_of<SetId::boundary>(columns...); }
inline constexpr NeededColumns none;

inline constexpr NeededColumns of_fluid = fluid(position, velocity, acceleration, density, density_rate, pressure, mass,
                                                smoothing_length, id, body, pressure_over_rho2);
inline constexpr NeededColumns of_solid =
    solid(position, velocity, acceleration, density, pressure, mass, smoothing_length, id, body, clamped);
inline constexpr NeededColumns of_hypoelastic =
    of_solid | solid(density_rate, deviatoric_stress, stress_over_rho2, velocity_gradient);
inline constexpr NeededColumns of_total_lagrangian =
    of_solid |
    solid(reference_position, volume, deformation, corrected_stress, gradient_correction, hourglass_stiffness);
inline constexpr NeededColumns of_elements =
    elements(position, area_normal, velocity, pressure, image_pressure, solid_weight, force, shared_force,
             smoothing_length, body) |
    solid(interface_acceleration, halfway_position, mean_velocity);
inline constexpr NeededColumns of_boundary =
    boundary(position, velocity, mean_acceleration, volume, smoothing_length, force, solid_id, body) |
    solid(interface_acceleration, halfway_position, mean_velocity, mean_acceleration);
inline constexpr NeededColumns of_wall = wall(position, pressure, volume, smoothing_length, id, body);

}  // namespace needed
}  // namespace sluice
