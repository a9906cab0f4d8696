#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/scene/check/checks.hpp"
#include "engine/scene/formula.hpp"

namespace sluice {
namespace {

bool is_fluid(const Scene& scene, const Body& body) {
    return scene.materials[body.material].kind == MaterialKind::fluid;
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Extent of a set of particles along a direction.
struct Heights {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    void add(const Heights& h) {
        lowest = std::min(lowest, h.lowest);
        highest = std::max(highest, h.highest);
    }
};

/// Particles count with their half spacings, so that a box reaches from its bottom to its top.
Heights heights_of(const Packing& packing, const Point& up) {
    Heights heights;
    double half = 0;
    for (std::size_t k = 0; k < 3; ++k) half += 0.5 * std::abs(up[k]) * packing.spacing[k];
    for (const Point& p : packing.position) {
        const double height = dot(p, up);
        heights.add({height - half, height + half});
    }
    return heights;
}

/// How far the fluid can fall straight down onto a mirror wall; 0 for walls steeper than 60°, which it slides along.
double fall_onto(const Wall& wall, const Packing& fluid, const Point& up) {
    constexpr double steepest = 0.5;  // cosine
    const double slope = dot(wall.normal, up);
    if (wall.kind != WallKind::mirror || slope < steepest) return 0;
    return (heights_of(fluid, wall.normal).highest - dot(wall.point, wall.normal)) / slope;
}

double fall_speed(const Scene& scene, const std::vector<Packing>& bodies) {
    const double g = std::sqrt(dot(scene.gravity, scene.gravity));
    if (!(g > 0)) return 0;
    const Point up{-scene.gravity[0] / g, -scene.gravity[1] / g, -scene.gravity[2] / g};
    Heights fluid, all;
    double fall = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Heights heights = heights_of(bodies[i], up);
        all.add(heights);
        if (!is_fluid(scene, scene.bodies[i])) continue;
        fluid.add(heights);
        for (const Wall& wall : scene.walls) fall = std::max(fall, fall_onto(wall, bodies[i], up));
    }
    for (const Packing& wall : pack_walls(scene)) all.add(heights_of(wall, up));
    return std::sqrt(2 * g * std::max(fall, fluid.highest - all.lowest));
}

double initial_speed(const Scene& scene, const Body& body, const Packing& packing) {
    double highest = 0;
    std::vector<CompiledFormula> velocity;
    for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension); ++k)
        velocity.emplace_back(scene, fmt::format("bodies.{}.velocity[{}]", body.name, k), body.velocity[k]);
    for (const Point& p : packing.position) {
        Point v{};
        for (std::size_t k = 0; k < velocity.size(); ++k) v[k] = velocity[k](p);
        highest = std::max(highest, std::sqrt(dot(v, v)));
    }
    return highest;
}

}  // namespace

double expected_fluid_speed(const Scene& scene, const std::vector<Packing>& bodies) {
    const auto fluid = [&](const Body& body) { return is_fluid(scene, body); };
    if (std::none_of(scene.bodies.begin(), scene.bodies.end(), fluid)) return 0;
    if (scene.method.expected_speed) return *scene.method.expected_speed;
    double highest = fall_speed(scene, bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        if (is_fluid(scene, body)) highest = std::max(highest, initial_speed(scene, body, bodies[i]));
    }
    return highest;
}

void check_mach(const Scene& scene, const std::vector<Packing>& bodies) {
    const double speed = expected_fluid_speed(scene, bodies);
    for (const Body& body : scene.bodies) {
        const Material& material = scene.materials[body.material];
        if (!is_fluid(scene, body)) continue;
        const double mach = speed / material.sound_speed;
        if (mach <= scene.method.mach_limit * (1 + 1e-12))
            continue;  // a quotient that should equal the limit may miss it by a rounding
        // Rounded up, so that the value in the message passes.
        const double enough = std::ceil(10 * speed / scene.method.mach_limit) / 10;
        scene.fail(
            "materials." + material.name + ".sound_speed",
            fmt::format(
                "found {} m/s; Mach {:.2g} expected ({:.3g} m/s{}), limit {}: raise sound_speed to at least {:.10g}",
                material.sound_speed, mach, speed, scene.method.expected_speed ? " by method.expected_speed" : "",
                scene.method.mach_limit, enough));
    }
}

}  // namespace sluice
