// Water in a periodic box, and how its waves are measured.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tests/engine/physics_scenes.hpp"

namespace sluice::waves {

inline constexpr double length = 0.1;                                 ///< of the box along x [m]
inline constexpr double wave_number = 2 * std::numbers::pi / length;  ///< k of one wave in it [1/m]
inline constexpr double sound_speed = 30;                             ///< of the preamble's water [m/s]

/// Water that fills a box of `length` by `width`, periodic along both axes. Nothing but pressure acts on it;
/// `initial` are lines of its body.
inline std::string box(double spacing, double width, const std::string& initial) {
    return preamble(spacing) + fmt::format(R"toml(
[domain]
periodic = {{ x = [0.0, {0}], y = [0.0, {1}] }}
[bodies.water]
material = "water"
shape = {{ box = {{ min = [0.0, 0.0], max = [{0}, {1}] }} }}
{2}
)toml",
                                           length, width, initial);
}

/// Without the paper's velocity filter, and with velocities that stand at the same time as positions.
inline std::vector<std::string> plain(std::vector<std::string> more = {}) {
    more.insert(more.end(), {"method.fluid.velocity_filter=1", "method.integrator=kick-drift-kick"});
    return more;
}

/// A sound wave that stands in the box, of highest speed `speed` [m/s].
inline std::string standing_sound(double speed) {
    return fmt::format("velocity = [\"{} * sin({} * x)\", \"0\"]", speed, wave_number);
}

/// Amplitude of sin(kx) in a component of the velocity. [m/s]
inline double amplitude(const Simulation<2>& s, int component, int along) {
    double sum = 0;
    for (std::size_t i = 0; i < s.fluid().owned; ++i)
        sum += s.fluid().velocity[i][component] * std::sin(wave_number * s.fluid().position[i][along]);
    return 2 * sum / static_cast<double>(s.fluid().owned);
}

/// Energy in motion and compression. [J/m]
inline double energy(const Simulation<2>& s) { return s.energy().kinetic + s.energy().compression; }

inline void advance_to(Simulation<2>& s, double time) {
    while (s.time() < time) s.step();
}

/// The rate at which amplitudes fade that carry this energy: ½ ln(E(0)/E(t))/t. [1/s]
inline double fading_rate(Simulation<2>& s, double time) {
    const double start = energy(s);
    advance_to(s, time);
    return 0.5 * std::log(start / energy(s)) / s.time();
}

}  // namespace sluice::waves
