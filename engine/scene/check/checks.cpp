#include "engine/scene/check/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/particle_count.hpp"
#include "engine/scene/check/memory_check.hpp"
#include "engine/scene/check/overlap.hpp"
#include "engine/scene/check/thickness.hpp"
#include "engine/scene/describe.hpp"
#include "kernels/smoothing.hpp"

namespace sluice {
namespace {

std::string key_of(const Body& body) { return "bodies." + body.name; }
std::string key_of(const Wall& wall) { return "walls." + wall.name; }

bool is_solid(const Scene& scene, const Body& body) {
    return scene.materials[body.material].kind == MaterialKind::solid;
}

/// `room`: how many particles the memory still holds; less by those that are placed.
Packing pack_region(const Scene& scene, const std::string& owner, const Shape& shape, double spacing, Fit fit,
                    double& room) {
    // Particle numbers and lattice coordinates have 32 bits.
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    const double sites = count_sites(shape, spacing, scene.dimension, fit);
    if (!(sites <= most))
        scene.fail(spacing_key(scene, owner),
                   fmt::format("found {} m, which makes {:.2g} lattice sites for {}, expected "
                               "a spacing that makes {:.2g} at the most",
                               spacing, sites, owner, most));
    // Placing them is what would fill the memory first.
    if (sites > room && holds_more_than(room, shape, spacing, scene.dimension, fit))
        scene.fail(spacing_key(scene, owner),
                   fmt::format("found {} m, which makes more than the {:.2g} particles for {} that fit into the free "
                               "memory; expected {:.2g} m or more",
                               spacing, room, owner, spacing * std::pow(sites / room, 1.0 / scene.dimension)));
    Packing packing = pack(shape, spacing, scene.dimension, fit);
    room -= static_cast<double>(packing.position.size());
    return packing;
}

void check_filled(const Scene& scene, const std::string& owner, double spacing, const Packing& packing) {
    if (packing.position.empty())
        scene.fail(owner + ".shape", fmt::format("found no particle in it at a spacing of {} m, expected one or more: "
                                                 "reduce {}",
                                                 spacing, spacing_key(scene, owner)));
}

/// One particle may fill a body, but it must not stand for much more than the body.
void check_size(const Scene& scene, const Body& body) {
    const Bounds bounds = body.shape->bounds();
    for (int k = 0; k < scene.dimension; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        const double size = bounds.max[axis] - bounds.min[axis];
        if (body.spacing <= 2 * size) continue;
        scene.fail(
            spacing_key(scene, key_of(body)),
            fmt::format("found a spacing of {:.4g} m, more than twice the {:.4g} m of {} along {}, expected {:.4g} "
                        "m or less",
                        body.spacing, size, key_of(body), "xyz"[axis], size));
    }
}

void check_thickness(const Scene& scene, const Body& body, const Packing& packing) {
    const auto thin = find_thin_place(*body.shape, packing, scene.dimension);
    if (!thin) return;
    scene.fail(
        spacing_key(scene, key_of(body)),
        fmt::format("found a spacing of {} m, which makes {} one particle thick along {} at {}, expected {:.4g} m or "
                    "less for two particles across its {:.4g} m",
                    body.spacing, key_of(body), "xyz"[thin->axis],
                    describe_place(scene, packing.position[thin->particle]), thin -> thickness / 2, thin -> thickness));
}

void check_mirrors(const Scene& scene, const Body& body, const Packing& packing) {
    for (const Wall& wall : scene.walls) {
        if (wall.kind != WallKind::mirror) continue;
        for (const Point& p : packing.position) {
            double depth = 0;
            for (std::size_t k = 0; k < 3; ++k) depth -= (p[k] - wall.point[k]) * wall.normal[k];
            if (depth < 0) continue;
            scene.fail(
                key_of(body) + ".shape",
                fmt::format("found a particle at {}, {:.3g} m behind {}, expected all of the fluid on the side that "
                            "its normal points to",
                            describe_place(scene, p), depth, describe_key(scene, key_of(wall))));
        }
    }
}

/// Fluid outside a periodic box would be brought back in on top of other fluid; in a box shorter than a support and a
/// skin, particles would miss images of images.
void check_periodic(const Scene& scene, const Body& body, const Packing& packing) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (!scene.periodic[k]) continue;
        const auto [low, high] = *scene.periodic[k];
        const std::string key = fmt::format("domain.periodic.{}", "xyz"[k]);
        const double least =
            (Smoothing<2>(scene.method.smoothing_function).support + 1) * scene.method.smoothing_length * body.spacing;
        if (high - low < least)
            scene.fail(key, fmt::format("found a length of {:.4g} m, expected {:.4g} m or more for {}, a support and a "
                                        "smoothing length",
                                        high - low, least, key_of(body)));
        for (const Point& p : packing.position)
            if (p[k] < low || p[k] > high)
                scene.fail(key_of(body) + ".shape",
                           fmt::format("found a particle at {}, expected all of the fluid inside {}",
                                       describe_place(scene, p), describe_key(scene, key)));
    }
}

void check_clamp(const Scene& scene, const Body& body, const Packing& packing) {
    if (!body.clamp) return;
    const auto held = [&](const Point& p) { return body.clamp->contains(p); };
    if (std::none_of(packing.position.begin(), packing.position.end(), held))
        scene.fail(key_of(body) + ".clamp",
                   fmt::format("found no particle of {} in it, expected one or more", key_of(body)));
}

void check_overlaps(const Scene& scene, const std::vector<Packing>& bodies, const std::vector<Packing>& walls) {
    const auto check = [&](const Body& body, const PackedRegion& a, const std::string& other, const PackedRegion& b) {
        const auto overlap = find_overlap(a, b);
        if (!overlap) return;
        scene.fail(
            key_of(body) + ".shape",
            fmt::format("found an overlap with {}: {} at {}, expected shapes that touch at the most",
                        describe_key(scene, other + ".shape"), overlap->what, describe_place(scene, overlap->place)));
    };
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        const PackedRegion region{body.shape.get(), &bodies[i], body.spacing};
        for (std::size_t j = 0; j < i; ++j) {
            const Body& other = scene.bodies[j];
            check(body, region, key_of(other), {other.shape.get(), &bodies[j], other.spacing});
        }
        for (std::size_t j = 0; j < walls.size(); ++j) {
            const Wall& wall = scene.walls[j];
            if (wall.kind == WallKind::fixed)
                check(body, region, key_of(wall), {wall.shape.get(), &walls[j], wall.spacing});
        }
    }
}

void check_displacement_probe(const Scene& scene, const Probe& probe, const std::vector<Packing>& bodies) {
    const Body& body = scene.bodies[*probe.body];
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& p : bodies[*probe.body].position)
        nearest = std::min(nearest, std::hypot(p[0] - probe.at[0], p[1] - probe.at[1], p[2] - probe.at[2]));
    const double h = scene.method.smoothing_length * body.spacing;
    if (nearest > h)
        scene.fail(
            "probes." + probe.name + ".at",
            fmt::format("found {}, {:.3g} m from the nearest particle of {}, expected a place within its smoothing "
                        "length of {:.3g} m",
                        describe_place(scene, probe.at), nearest, describe_key(scene, key_of(body)), h));
}

}  // namespace

std::vector<Packing> pack_bodies(const Scene& scene) {
    std::vector<Packing> packings;
    double room = particles_in(available_memory(), scene.dimension);
    for (const Body& body : scene.bodies)
        packings.push_back(pack_region(scene, key_of(body), *body.shape, body.spacing, Fit::outside, room));
    return packings;
}

std::vector<Packing> pack_walls(const Scene& scene) {
    std::vector<Packing> packings;
    double room = particles_in(available_memory(), scene.dimension);
    for (const Wall& wall : scene.walls)
        packings.push_back(wall.kind == WallKind::fixed
                               ? pack_region(scene, key_of(wall), *wall.shape, wall.spacing, Fit::cavity, room)
                               : Packing{});
    return packings;
}

void check_geometry(const Scene& scene, const std::vector<Packing>& bodies, const std::vector<Packing>& walls) {
    check_memory(scene, bodies, walls, available_memory());
    for (std::size_t i = 0; i < walls.size(); ++i)
        if (scene.walls[i].kind == WallKind::fixed)
            check_filled(scene, key_of(scene.walls[i]), scene.walls[i].spacing, walls[i]);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        check_filled(scene, key_of(body), body.spacing, bodies[i]);
        check_size(scene, body);
        if (is_solid(scene, body)) check_thickness(scene, body, bodies[i]);
        if (!is_solid(scene, body)) {
            check_mirrors(scene, body, bodies[i]);
            check_periodic(scene, body, bodies[i]);
        }
        check_clamp(scene, body, bodies[i]);
    }
    check_overlaps(scene, bodies, walls);
    for (const Probe& probe : scene.probes)
        if (probe.kind == ProbeKind::displacement) check_displacement_probe(scene, probe, bodies);
}

}  // namespace sluice
