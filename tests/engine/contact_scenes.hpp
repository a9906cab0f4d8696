// Elastic bodies that meet each other and walls.
#pragma once

#include <fmt/format.h>

#include "tests/engine/physics_scenes.hpp"

namespace sluice::contact_scenes {

/// The rubber of the other scenes without water and without dissipation: K = 2 MPa, c0 = √(K/ρ) = 42.64 m/s.
inline std::string rubber(double spacing, const std::string& head = "") {
    return "title = \"contact\"\n" + head +
           fmt::format(R"toml([method]
preset = "modern"
spacing = {}
[method.solid]
artificial_viscosity = 0.0
hourglass_control = 0.1
[materials.rubber]
kind = "solid"
model = "neo-hookean"
density = 1100.0
youngs_modulus = 1.2e6
poisson_ratio = 0.4
[output]
end = 1.0
)toml",
                       spacing);
}
inline constexpr double sound_speed = 42.64;

inline std::string body(const std::string& name, const std::string& shape, const std::string& velocity) {
    return fmt::format("[bodies.{}]\nmaterial = \"rubber\"\nshape = {}\nvelocity = {}\n", name, shape, velocity);
}

inline std::string box(const std::string& min, const std::string& max) {
    return fmt::format("{{ box = {{ min = {}, max = {} }} }}", min, max);
}

inline std::string disc(double x, double y, double radius) {
    return fmt::format("{{ circle = {{ centre = [{}, {}], radius = {} }} }}", x, y, radius);
}

inline std::string ring(double x, double outer, double inner) {
    return fmt::format("{{ difference = [{}, {}] }}", disc(x, 0, outer), disc(x, 0, inner));
}

/// Its surface at y = 0, like the mirror's.
inline const std::string fixed_floor = R"toml(
[walls.floor]
kind = "fixed"
shape = { box = { min = [-0.02, -0.004], max = [0.02, 0.0] } }
)toml";

/// The lowest centre of a body's particles.
template <int Dim>
double lowest(const Simulation<Dim>& s, std::size_t number = 0) {
    double y = 1e300;
    for (std::size_t i = 0; i < s.solid().owned; ++i)
        if (s.solid().body[i] == number) y = std::min(y, s.solid().position[i][1]);
    return y;
}

/// Of a body's particles' centres along x: smallest and largest.
template <int Dim>
std::array<double, 2> range_of(const Simulation<Dim>& s, std::size_t number) {
    std::array<double, 2> range{1e300, -1e300};
    for (std::size_t i = 0; i < s.solid().owned; ++i) {
        if (s.solid().body[i] != number) continue;
        range[0] = std::min(range[0], s.solid().position[i][0]);
        range[1] = std::max(range[1], s.solid().position[i][0]);
    }
    return range;
}

template <int Dim>
double mass_of(const Simulation<Dim>& s, std::size_t number = 0) {
    double mass = 0;
    for (std::size_t i = 0; i < s.solid().owned; ++i)
        if (s.solid().body[i] == number) mass += s.solid().mass[i];
    return mass;
}

template <int Dim>
Vec<Dim> momentum_of(const Simulation<Dim>& s, std::size_t number) {
    Vec<Dim> sum;
    for (std::size_t i = 0; i < s.solid().owned; ++i)
        if (s.solid().body[i] == number) sum += s.solid().mass[i] * s.solid().velocity[i];
    return sum;
}

}  // namespace sluice::contact_scenes
