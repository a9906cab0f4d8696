#include "bench/dam_break.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace sluice::bench {
namespace {

/// A vector's components as a TOML array, in as many dimensions as the scene has.
std::string array(const DamBreak& dam, double x, double y, double z) {
    return dam.dimension == 2 ? fmt::format("[{:f}, {:f}]", x, y) : fmt::format("[{:f}, {:f}, {:f}]", x, y, z);
}

std::string wall(const DamBreak& dam, const char* name, const std::array<double, 3>& point,
                 const std::array<double, 3>& normal) {
    return fmt::format("[walls.{}]\nkind = \"mirror\"\npoint = {}\nnormal = {}\n", name,
                       array(dam, point[0], point[1], point[2]), array(dam, normal[0], normal[1], normal[2]));
}

/// Expected: 2 √(gH), the front on a dry bed. Sound at ten times that. At the start a stagnation flow, half as fast:
/// free of divergence, and along the walls.
std::string text_of(const DamBreak& dam) {
    const double expected = 2 * std::sqrt(9.81 * 1.0), begun = 0.5 * expected;
    const double side = std::round(std::pow(dam.particles, 1.0 / dam.dimension));
    std::string text =
        fmt::format("title = \"Dam break\"\ndimension = {}\ngravity = {}\n", dam.dimension, array(dam, 0, -9.81, 0));
    text += fmt::format(
        "[method]\npreset = \"paper\"\nspacing = {}\nsmoothing_length = {}\nprecision = \"{}\"\nexpected_speed = "
        "{}\n[method.fluid]\n"
        "velocity_filter = 0.92\n",
        1 / side, dam.h_over_d, dam.precision, expected);
    text += fmt::format("[materials.water]\nkind = \"fluid\"\ndensity = 1000.0\nsound_speed = {}\n", 10 * expected);
    text += fmt::format(
        "[bodies.water]\nmaterial = \"water\"\nshape = {{box = {{min = {}, max = {}}}}}\nhydrostatic_surface = 1.0\n"
        "velocity = [\"{:f}*x\", \"-{:f}*y\"{}]\n",
        array(dam, 0, 0, 0), array(dam, 1, 1, 1), begun, begun, dam.dimension == 3 ? ", \"0\"" : "");
    text += wall(dam, "floor", {0, 0, 0}, {0, 1, 0}) + wall(dam, "left", {0, 0, 0}, {1, 0, 0}) +
            wall(dam, "right", {3, 0, 0}, {-1, 0, 0});
    if (dam.dimension == 3) text += wall(dam, "front", {0, 0, 0}, {0, 0, 1}) + wall(dam, "rear", {0, 0, 1}, {0, 0, -1});
    return text + "[output]\nend = 1.0\n";
}

}  // namespace

Scene make_scene(const DamBreak& dam) {
    const auto file = std::filesystem::temp_directory_path() / fmt::format("sluice-dam-break-{}.toml", ::getpid());
    std::ofstream(file) << text_of(dam);
    const Scene scene = load_scene(file.string());
    std::filesystem::remove(file);
    return scene;
}

}  // namespace sluice::bench
