// The phases of a step, by name: where the terms of effects run, and what time is told for.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace sluice {

enum class StepPhase {
    search,
    fluid_pass,
    filter_pass,
    density_pass,
    shift_pass,
    solid_pass,
    gradient_pass,
    contact_pass,
    interface_pass,
    wall_pass,
    update,
    output
};
inline constexpr std::array<std::string_view, 12> step_phase_names{"neighbour search",
                                                                   "fluid momentum",
                                                                   "velocity filter",
                                                                   "fluid density",
                                                                   "particle shifting",
                                                                   "solid momentum",
                                                                   "solid gradient and stress",
                                                                   "contact",
                                                                   "interface",
                                                                   "walls and images",
                                                                   "update",
                                                                   "output"};
static_assert(step_phase_names.size() == static_cast<std::size_t>(StepPhase::output) + 1);

constexpr std::string_view name_of(StepPhase phase) { return step_phase_names[static_cast<std::size_t>(phase)]; }

}  // namespace sluice
