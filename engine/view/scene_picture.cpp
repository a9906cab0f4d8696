#include "engine/view/scene_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/geometry/packing.hpp"
#include "engine/scene/check/checks.hpp"
#include "engine/study/words.hpp"
#include "engine/view/drawing.hpp"
#include "engine/view/particle_raster.hpp"
#include "engine/view/rulers.hpp"
#include "engine/view/scene_legend.hpp"
#include "engine/view/scene_marks.hpp"

namespace sluice {
namespace {

constexpr int width = 1280, height = 720;
constexpr PictureBox box{66, 70, 960, 640};  ///< that the scene fills
constexpr PictureBox frame{40, 56, 986, 662};
constexpr double legend_left = 1010;

// Of bodies in turn; several of a medium are told apart.
constexpr std::array<std::uint32_t, 4> fluid_colors{0x458cc7, 0x2f9e93, 0x7d72c9, 0x5aa0e6};
constexpr std::array<std::uint32_t, 4> solid_colors{0xd18042, 0xbf4f51, 0xb0962b, 0x9a6a8f};
constexpr std::array<std::uint32_t, 2> wall_colors{0x98a1ab, 0xb9b3a4};

std::vector<DrawnSet> sets_of(const Scene& scene, const std::vector<Packing>& bodies,
                              const std::vector<Packing>& walls) {
    std::vector<DrawnSet> sets;
    std::size_t fluids = 0, solids = 0, fixed = 0;
    const auto note = [](const char* what, const Packing& packing, double spacing) {
        return fmt::format("{}, {} at {}", what, count_text(packing.position.size()), length_text(spacing));
    };
    for (std::size_t k = 0; k < walls.size(); ++k)
        if (const Wall& wall = scene.walls[k]; wall.kind == WallKind::fixed)
            sets.push_back({wall.name, note("wall", walls[k], wall.spacing), &walls[k], nullptr, wall.spacing,
                            wall_colors[fixed++ % wall_colors.size()]});
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const Body& body = scene.bodies[k];
        const bool fluid = scene.materials[body.material].kind == MaterialKind::fluid;
        sets.push_back(
            {body.name, note(fluid ? "fluid" : "solid", bodies[k], body.spacing), &bodies[k], body.clamp.get(),
             body.spacing,
             fluid ? fluid_colors[fluids++ % fluid_colors.size()] : solid_colors[solids++ % solid_colors.size()]});
    }
    return sets;
}

void extend(Projection::Bounds& bounds, const Point& p) {
    for (std::size_t k = 0; k < 3; ++k) {
        bounds[k].first = std::min(bounds[k].first, p[k]);
        bounds[k].second = std::max(bounds[k].second, p[k]);
    }
}

/// The foot of the perpendicular from the middle of what is shown.
Point foot_on(const Wall& wall, const Projection::Bounds& bounds) {
    Point foot;
    double above = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        foot[k] = 0.5 * (bounds[k].first + bounds[k].second);
        above += (foot[k] - wall.point[k]) * wall.normal[k];
    }
    for (std::size_t k = 0; k < 3; ++k) foot[k] -= above * wall.normal[k];
    return foot;
}

/// All that is to be seen, and a little more.
Projection::Bounds bounds_of(const Scene& scene, const std::vector<DrawnSet>& sets) {
    const double margin = scene.dimension == 2 ? 0.03 : 0;  // in 3D the box that is drawn ends where its walls are
    Projection::Bounds bounds;
    bounds.fill({INFINITY, -INFINITY});
    for (const DrawnSet& set : sets)
        for (const Point& p : set.packing->position)
            for (const double half : {-0.5 * set.spacing, 0.5 * set.spacing})
                extend(bounds, {p[0] + half, p[1] + half, scene.dimension == 3 ? p[2] + half : 0});
    if (!(bounds[0].first <= bounds[0].second)) bounds.fill({0, 1});  // not a single particle
    if (scene.dimension == 2) bounds[2] = {0, 0};
    for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension); ++k)
        if (scene.periodic[k]) {
            bounds[k].first = std::min(bounds[k].first, scene.periodic[k]->first);
            bounds[k].second = std::max(bounds[k].second, scene.periodic[k]->second);
        }
    for (const Probe& probe : scene.probes)
        if (probe.has_place() && probe.kind != ProbeKind::water_level) extend(bounds, probe.at);
    for (const Wall& wall : scene.walls)
        if (wall.kind == WallKind::mirror) extend(bounds, foot_on(wall, bounds));
    double largest = 0;
    for (const auto& [low, high] : bounds) largest = std::max(largest, high - low);
    for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension); ++k) {
        bounds[k].first -= margin * largest;
        bounds[k].second += margin * largest;
    }
    return bounds;
}

void draw_particles(Drawing& drawing, const MarkPlace& at, const std::vector<DrawnSet>& sets) {
    constexpr double gap = 0.9;  // of a diameter, so that particles are seen one by one where they are large enough
    std::vector<Sprite> sprites;
    for (const DrawnSet& set : sets)
        for (const Point& place : set.packing->position) {
            const Point p = at.to(place);
            const bool held = set.clamp && set.clamp->contains(place);
            sprites.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]),
                               static_cast<float>(0.5 * gap * set.spacing * at.to.pixels_per_metre()),
                               at.scene.dimension == 3 ? static_cast<float>(p[2]) : 0.0F,
                               held ? darkened(set.color) : set.color});
        }
    ParticleRaster raster(width, height);
    raster.draw(sprites, at.scene.dimension == 2 ? Shading::flat : Shading::ball);
    raster.blend_into(drawing.pixels(), drawing.stride());
    drawing.pixels_changed();
}

}  // namespace

std::string scene_picture(const Scene& scene) {
    const std::vector<Packing> bodies = pack_bodies(scene), walls = pack_walls(scene);
    const std::vector<DrawnSet> sets = sets_of(scene, bodies, walls);
    const Projection::Bounds bounds = bounds_of(scene, sets);
    Point up{0, 1, 0};
    if (scene.gravity != Point{})
        for (std::size_t k = 0; k < 3; ++k) up[k] = -scene.gravity[k];
    const Projection to =
        scene.dimension == 2 ? Projection::flat(bounds, box) : Projection::oblique(bounds, box, up, {});
    const MarkPlace at{scene, to, bounds, box, palette_of(Theme::light)};
    Drawing drawing(width, height, at.palette.page);
    drawing.clip(frame);
    draw_planes(drawing, at);
    drawing.unclip();
    draw_particles(drawing, at, sets);
    draw_periodic_sides(drawing, at);
    draw_probes(drawing, at);
    if (scene.dimension == 2)
        draw_rulers(drawing, to, box, 1, at.palette);
    else
        draw_axes(drawing, to, {box.right - 40.0, height - 50.0}, at.palette);
    draw_scale_bar(drawing, to, {box.left, box.top, box.right, height - 16.0}, at.palette);
    drawing.text(28, 36, scene.title.empty() ? scene.file : scene.title, 20, at.palette.ink);
    draw_legend(drawing, at, sets, {legend_left, box.top + 10.0});
    return drawing.png();
}

}  // namespace sluice
