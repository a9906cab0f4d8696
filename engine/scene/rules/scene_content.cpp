#include "engine/scene/rules/scene_content.hpp"

#include <algorithm>

namespace sluice {
namespace {

void add_name(std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; }

void add_once(std::vector<std::string>& list, const std::string& name) {
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
}

/// Whether a clamp holds all of a body: if it is convex and holds the corners of what bounds the body.
bool is_held(const Body& body) {
    if (!body.clamp) return false;
    const Bounds b = body.shape->bounds();
    for (unsigned corner = 0; corner < 8; ++corner) {
        Point p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = corner >> k & 1U ? b.max[k] : b.min[k];
        if (!body.clamp->contains(p)) return false;
    }
    return true;
}

void add_fluid(const Body& body, const Material& material, SceneContent& c) {
    c.fluid = true;
    if (material.viscosity > 0) c.viscous = true;
    add_name(c.fluids, body.name);
    add_once(c.fluid_materials, material.name);
}

void add_solid(const Body& body, const Material& material, SceneContent& c) {
    c.solid = true;
    if (law_of(material.model)) {
        c.total_lagrangian = true;
        ++c.total_lagrangian_bodies;
    } else {
        c.hypoelastic = true;
    }
    if (!is_held(body)) c.movable = true;
    add_name(c.solids, body.name);
    add_once(c.solid_materials, material.name);
}

void add_bodies(const Scene& scene, SceneContent& c) {
    double smallest = 1e300, largest = 0;
    for (const Body& body : scene.bodies) {
        const Material& material = scene.materials[body.material];
        switch (material.kind) {
            case MaterialKind::fluid:
                add_fluid(body, material, c);
                break;
            case MaterialKind::solid:
                add_solid(body, material, c);
                break;
        }
        if (body.clamp) c.clamp = true, add_name(c.clamps, body.name);
        smallest = std::min(smallest, body.spacing);
        largest = std::max(largest, body.spacing);
    }
    c.many_spacings = largest > smallest * (1 + 1e-9);
}

void add_walls(const Scene& scene, SceneContent& c) {
    for (const Wall& wall : scene.walls) {
        switch (wall.kind) {
            case WallKind::mirror:
                c.mirror = true;
                add_name(c.mirrors, wall.name);
                break;
            case WallKind::fixed:
                c.fixed = true;
                add_name(c.fixed_walls, wall.name);
                break;
        }
        if (wall.condition == WallCondition::no_slip) c.no_slip = true, add_name(c.no_slip_walls, wall.name);
        if (wall.motion.moves()) c.moving_wall = true, add_name(c.moving_walls, wall.name);
    }
}

}  // namespace

SceneContent content_of(const Scene& scene) {
    SceneContent c;
    add_bodies(scene, c);
    add_walls(scene, c);
    for (std::size_t k = 0; k < 3; ++k)
        if (scene.periodic[k]) add_name(c.periodic_axes, std::string(1, "xyz"[k]));
    c.driven = scene.acceleration != std::array<Formula, 3>{};
    c.gravity = std::any_of(scene.gravity.begin(), scene.gravity.end(), [](double g) { return g != 0; });
    return c;
}

}  // namespace sluice
