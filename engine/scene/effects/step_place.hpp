// Places in a step: where the terms of effects run, for profiles.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "engine/scene/effects/step_phase.hpp"

namespace sluice {

/// A phase as a whole, its loops over pairs of one name (pass_name), or what of it is none of its loops.
struct StepPlace {
    enum class Part { whole, loop, rest };
    StepPhase phase{};
    Part part = Part::whole;
    std::string_view loop = {};

    /// Whether that loop of that phase belongs to it; without a name: the rest of the phase.
    constexpr bool has(std::string_view of_phase, std::string_view of_loop) const {
        return of_phase == name_of(phase) && (part == Part::whole || of_loop == loop);
    }
};

/// A few places.
class StepPlaces {
  public:
    constexpr StepPlaces() = default;
    constexpr StepPlaces(const StepPlace& place) { add(place); }

    constexpr auto begin() const { return places_.begin(); }
    constexpr auto end() const { return places_.begin() + count_; }
    constexpr bool has(std::string_view phase, std::string_view loop) const {
        for (const StepPlace& place : *this)
            if (place.has(phase, loop)) return true;
        return false;
    }
    friend constexpr StepPlaces operator|(StepPlaces a, const StepPlaces& b) {
        for (const StepPlace& place : b) a.add(place);
        return a;
    }

  private:
    constexpr void add(const StepPlace& place) { places_.at(static_cast<std::size_t>(count_++)) = place; }

    std::array<StepPlace, 8> places_{};
    std::ptrdiff_t count_ = 0;
};

/// The words of which effects.def says where an effect's terms run: in(wall_pass, "ghost force") | rest_of(update).
namespace step_places {

using enum StepPhase;

inline constexpr StepPlaces nowhere;
constexpr StepPlaces whole(StepPhase phase) { return StepPlace{phase}; }
constexpr StepPlaces rest_of(StepPhase phase) { return StepPlace{phase, StepPlace::Part::rest}; }
constexpr StepPlaces in(StepPhase phase, auto... loops) {
    return (StepPlaces() | ... | StepPlaces(StepPlace{phase, StepPlace::Part::loop, loops}));
}

}  // namespace step_places
}  // namespace sluice
