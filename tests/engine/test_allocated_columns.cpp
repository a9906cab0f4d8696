// What is allocated is what the effects that are on need, and nothing else.
#include <set>
#include <sstream>

#include "engine/particles/particle_set.hpp"
#include "tests/catch.hpp"
#include "tests/engine/effect_scenes.hpp"

namespace sluice::test_allocated_columns {
namespace {

using Names = std::set<std::string>;

void add_allocated(const std::string& name, const ParticleSet<2>& set, Names& columns) {
    for_each_array(set, [&](const ColumnInfo& info, const auto& values) {
        if (values.size() > 0) columns.insert(name + "." + std::string(info.name));
    });
}

/// Names that hold something, after some steps: scratch would have grown by then.
Names allocated(const std::string& content, const std::vector<std::string>& overrides) {
    Simulation<2> s(scene_text::load(effect_scenes::scene(content), overrides));
    advance(s, 3);
    Names columns;
    add_allocated("fluid", s.fluid(), columns);
    add_allocated("solid", s.solid(), columns);
    add_allocated("wall", s.wall(), columns);
    add_allocated("elements", s.interface(), columns);
    add_allocated("boundary", s.boundary(), columns);
    return columns;
}

/// "phase", "column column" as a set.
Names of(const std::string& phase, const std::string& names) {
    Names columns;
    std::istringstream stream(names);
    for (std::string name; stream >> name;) columns.insert(phase + "." + name);
    return columns;
}

Names operator+(Names a, const Names& b) {
    a.insert(b.begin(), b.end());
    return a;
}

const Names fluid = of("fluid",
                         "position velocity acceleration density density_rate pressure mass smoothing_length id body "
                         "pressure_over_rho2");
const Names any_solid =
    of("solid", "position velocity acceleration density pressure mass smoothing_length id body clamped");
const Names hypoelastic =
    any_solid + of("solid", "density_rate deviatoric_stress stress_over_rho2 velocity_gradient");
const Names total_lagrangian =
    any_solid +
    of("solid", "reference_position volume deformation corrected_stress gradient_correction hourglass_stiffness");
const Names filter = of("fluid", "velocity_correction");
const Names shifting =
    of("fluid", "concentration_gradient surface_normal position_divergence concentration surface_volume");
const Names elements =
    of("elements",
       "position area_normal velocity pressure image_pressure solid_weight force shared_force smoothing_length body") +
    of("solid", "interface_acceleration halfway_position mean_velocity");
const Names boundary = of("boundary", "position velocity mean_acceleration volume smoothing_length force solid_id body") +
                         of("solid", "interface_acceleration halfway_position mean_velocity mean_acceleration");
const Names wall = of("wall", "position pressure volume smoothing_length id body");
const Names artificial_stress = of("solid", "artificial_stress");

const std::string both = effect_scenes::water + effect_scenes::block;
const std::string reference = "materials.rubber.model=st-venant-kirchhoff";

}  // namespace

TEST_CASE("A scene of fluid holds the fluid's columns and those of what acts on it") {
    const std::string& water = effect_scenes::water;
    CHECK(allocated(water, {"method.fluid.velocity_filter=1"}) == fluid);
    CHECK(allocated(water, {}) == fluid + filter);
    CHECK(allocated(water, {"method.preset=modern"}) == fluid + shifting);
    CHECK(allocated(water, {"method.preset=modern", "effects.particle_shifting=off"}) == fluid);
    CHECK(allocated(water, {"method.preset=modern", "method.fluid.density_diffusion=antuono"}) ==
          fluid + shifting + of("fluid", "density_gradient"));
    CHECK(allocated(water, {"method.fluid.density_diffusion=antuono", "effects.density_diffusion=off"}) ==
          fluid + filter);
    CHECK(allocated(water + mirror_floor, {}) == fluid + filter);
    CHECK(allocated(water + effect_scenes::fixed, {}) == fluid + filter + wall);
    CHECK(allocated(water + effect_scenes::moving, {}) ==
          fluid + filter + wall + of("wall", "initial_position velocity"));
    CHECK(allocated(effect_scenes::periodic + water, {}) == fluid + filter);
}

TEST_CASE("A scene of solids holds the columns of their model") {
    const std::string& block = effect_scenes::block;
    CHECK(allocated(block, {}) == hypoelastic + artificial_stress);
    CHECK(allocated(block, {"effects.artificial_stress=off"}) == hypoelastic);
    CHECK(allocated(block, {"method.solid.artificial_stress=0", "method.solid.velocity_filter=0.9"}) ==
          hypoelastic + of("solid", "velocity_correction"));
    for (const char* model : {"st-venant-kirchhoff", "neo-hookean"})
        CHECK(allocated(block, {std::string("materials.rubber.model=") + model}) == total_lagrangian);
    CHECK(allocated(block, {"method.preset=modern"}) == total_lagrangian);
}

TEST_CASE("A scene of both holds the columns of its coupling") {
    const std::vector<std::string> paper{"method.fluid.velocity_filter=1", "method.solid.artificial_stress=0"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), paper.begin(), paper.end());
        return more;
    };
    CHECK(allocated(both, with({})) == fluid + hypoelastic + elements);
    CHECK(allocated(both, with({reference})) == fluid + total_lagrangian + elements);
    const std::string coupling = "method.coupling=moving-boundary";
    CHECK(allocated(both, with({coupling})) == fluid + hypoelastic + boundary);
    CHECK(allocated(both, with({coupling, reference})) == fluid + total_lagrangian + boundary);
    CHECK(allocated(both, {"method.preset=modern"}) ==
          fluid + shifting + total_lagrangian + boundary + of("solid", "steady_acceleration"));
}

}  // namespace sluice::test_allocated_columns
