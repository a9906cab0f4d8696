// What a study tells about runs to come: which settings reach a target, at what cost, and what to expect of a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/study/study.hpp"

namespace sluice {

/// How a figure came about. Between two measured spacings it lies on the straight line in logarithms; beyond the finest
/// on the fitted slopes.
enum class Basis { measured, interpolated, extrapolated };
template <>
inline constexpr std::array words_of<Basis>{
    Word{Basis::measured, "measured"},
    Word{Basis::interpolated, "interpolated"},
    Word{Basis::extrapolated, "extrapolated"},
};

struct Choice {
    std::size_t method = 0;
    double spacing = 0;  ///< [m]
    double cpu = 0;      ///< [s]
    double error = 0;    ///< relative
    Basis basis = Basis::measured;
};

/// For each method that reaches the error, the largest spacing from which on down all runs keep it; cheapest first.
/// Beyond its finest spacing a method is followed to half of it at the most, and only where the slope of its errors is
/// known (three points or more, at least 0.5, twice its scatter, and at least 0.5 in the last step as well).
std::vector<Choice> choices_for(const Study& study, std::size_t quantity, double target);

/// What to expect of a method at a spacing; none beyond what choices_for() would follow.
std::optional<Choice> expected(const Study& study, std::size_t quantity, std::size_t method, double spacing);

/// The error to advise on: a round number at least twice the least that was measured and no less than the truth's own
/// uncertainty; none without a run.
std::optional<double> target_of(const Study& study, std::size_t quantity);

/// "spacing 1.2 mm, modern, mixed: 9.0 CPU-s (interpolated)"
std::string choice_text(const Study& study, const Choice& choice);

/// Which settings reach `target`, and what the other methods need for it; in lines.
std::string target_text(const Study& study, std::size_t quantity, double target);

/// For each quantity: a target, half of it, and where the truth's uncertainty ends all gain; in lines.
std::vector<std::string> advice(const Study& study);

/// "Xeon, 2 processors, avx512"
std::string machine_text(const Study& study);

}  // namespace sluice
