// What a scene can choose between, each with its words.
#pragma once

#include <optional>

#include "engine/scene/table/word.hpp"
#include "kernels/choices.hpp"

namespace sluice {

enum class MaterialKind { fluid, solid };
template <>
inline constexpr std::array words_of<MaterialKind>{
    Word{MaterialKind::fluid, "fluid"},
    Word{MaterialKind::solid, "solid"},
};

/// Pressure over density: p = ρ0 c0²/γ ((ρ/ρ0)^γ − 1) with γ = 1, or that of water.
enum class PressureLaw { linear, tait };
template <>
inline constexpr std::array words_of<PressureLaw>{
    Word{PressureLaw::linear, "linear"},
    Word{PressureLaw::tait, "tait"},
};

/// How a solid's stress follows from its motion: by rates in the deformed body, as in the paper, or from its reference
/// configuration (total Lagrangian), by one of the elastic laws.
enum class SolidModel {
    hypoelastic,
#define SLUICE_ELASTIC_LAW(law, ...) law,
#include "kernels/elastic_laws.def"
#undef SLUICE_ELASTIC_LAW
};
template <>
inline constexpr std::array words_of<SolidModel>{
    Word{SolidModel::hypoelastic, "hypoelastic"},
#define SLUICE_ELASTIC_LAW(law, Formulas, word) Word{SolidModel::law, word},
#include "kernels/elastic_laws.def"
#undef SLUICE_ELASTIC_LAW
};
/// Of a total-Lagrangian solid; none for a hypoelastic one.
constexpr std::optional<ElasticLaw> law_of(SolidModel model) {
    switch (model) {
        case SolidModel::hypoelastic:
            break;
#define SLUICE_ELASTIC_LAW(law, ...) \
    case SolidModel::law:            \
        return ElasticLaw::law;
#include "kernels/elastic_laws.def"
#undef SLUICE_ELASTIC_LAW
    }
    return std::nullopt;
}

enum class WallKind { mirror, fixed };
template <>
inline constexpr std::array words_of<WallKind>{
    Word{WallKind::mirror, "mirror"},
    Word{WallKind::fixed, "fixed"},
};

/// How a viscous fluid moves along a wall.
enum class WallCondition { slip, no_slip };
template <>
inline constexpr std::array words_of<WallCondition>{
    Word{WallCondition::slip, "slip"},
    Word{WallCondition::no_slip, "no-slip"},
};

/// An axis of space; its value is the index of the coordinate.
enum class Direction : std::size_t { x = 0, y = 1, z = 2 };
template <>
inline constexpr std::array words_of<Direction>{
    Word{Direction::x, "x"},
    Word{Direction::y, "y"},
    Word{Direction::z, "z"},
};

/// What a formula depends on: x, y and z, or t, or all four.
enum class Variable { place, time, place_and_time };
template <>
inline constexpr std::array words_of<Variable>{
    Word{Variable::place, "x y z"},
    Word{Variable::time, "t"},
    Word{Variable::place_and_time, "x y z t"},
};

enum class ProbeKind { displacement, pressure, water_level, energy, momentum, force, velocity_error };
template <>
inline constexpr std::array words_of<ProbeKind>{
    Word{ProbeKind::displacement, "displacement"},
    Word{ProbeKind::pressure, "pressure"},
    Word{ProbeKind::water_level, "water_level"},
    Word{ProbeKind::energy, "energy"},
    Word{ProbeKind::momentum, "momentum"},
    Word{ProbeKind::force, "force"},
    Word{ProbeKind::velocity_error, "velocity_error"},
};

/// How a curve is compared with its reference: point by point (rms, max), or by one number that both have.
enum class Measure { rms, max, peak, peak_time, period, final, mean };
template <>
inline constexpr std::array words_of<Measure>{
    Word{Measure::rms, "rms", "RMS distance"},
    Word{Measure::max, "max", "largest distance"},
    Word{Measure::peak, "peak"},
    Word{Measure::peak_time, "peak_time", "time of the peak"},
    Word{Measure::period, "period"},
    Word{Measure::final, "final", "value at the end"},
    Word{Measure::mean, "mean", "mean over time"},
};

// Of the method.

enum class Preset { paper, modern };
template <>
inline constexpr std::array words_of<Preset>{
    Word{Preset::paper, "paper"},
    Word{Preset::modern, "modern"},
};

template <>
inline constexpr std::array words_of<SmoothingFunction>{
    Word{SmoothingFunction::cubic_spline, "cubic-spline"},
    Word{SmoothingFunction::wendland_c2, "wendland-c2"},
    Word{SmoothingFunction::wendland_c4, "wendland-c4"},
    Word{SmoothingFunction::quintic_spline, "quintic-spline"},
};

/// How fluid and solid feel each other: by a pressure on the elements of their interface (paper), or with the solid's
/// particles as the fluid's moving boundary.
enum class CouplingScheme { interface_force, moving_boundary };
template <>
inline constexpr std::array words_of<CouplingScheme>{
    Word{CouplingScheme::interface_force, "interface-force"},
    Word{CouplingScheme::moving_boundary, "moving-boundary"},
};

/// Of the pair arithmetic.
template <>
inline constexpr std::array words_of<Precision>{
    Word{Precision::full, "double"},
    Word{Precision::mixed, "mixed"},
};

enum class Integrator { staggered_euler, kick_drift_kick };
template <>
inline constexpr std::array words_of<Integrator>{
    Word{Integrator::staggered_euler, "staggered-euler"},
    Word{Integrator::kick_drift_kick, "kick-drift-kick"},
};

enum class StepSize { fixed, adaptive };
template <>
inline constexpr std::array words_of<StepSize>{
    Word{StepSize::fixed, "fixed"},
    Word{StepSize::adaptive, "adaptive"},
};

/// All media at the smallest Courant limit, or each at its own.
enum class TimeStepping { single_rate, multi_rate };
template <>
inline constexpr std::array words_of<TimeStepping>{
    Word{TimeStepping::single_rate, "single-rate"},
    Word{TimeStepping::multi_rate, "multi-rate"},
};

/// Of a viscous fluid; the other values stand for fluids without.
template <>
inline constexpr std::array words_of<Viscosity>{
    Word{Viscosity::morris, "morris", "Morris et al."},
    Word{Viscosity::monaghan_gingold, "monaghan-gingold", "Monaghan and Gingold"},
};

template <>
inline constexpr std::array words_of<DensityDiffusion>{
    Word{DensityDiffusion::none, "none"},
    Word{DensityDiffusion::molteni_colagrossi, "molteni-colagrossi", "Molteni and Colagrossi"},
    Word{DensityDiffusion::fourtakas, "fourtakas", "Fourtakas et al."},
    Word{DensityDiffusion::antuono, "antuono", "Antuono et al."},
};

// Of a run.

/// What to do when the computation breaks down: stop; go back to the last good state and on with half the step; or, as
/// long as numbers are finite, go on.
enum class WatchPolicy { stop, retry, warn };
template <>
inline constexpr std::array words_of<WatchPolicy>{
    Word{WatchPolicy::stop, "stop"},
    Word{WatchPolicy::retry, "retry"},
    Word{WatchPolicy::warn, "warn"},
};

/// What a scene may say of an effect in [effects].
enum class Switch { automatic, on, off };
template <>
inline constexpr std::array words_of<Switch>{
    Word{Switch::automatic, "auto"},
    Word{Switch::on, "on"},
    Word{Switch::off, "off"},
};

}  // namespace sluice
