#include <fmt/format.h>

#include <cmath>

#include "engine/scene/formula.hpp"
#include "engine/scene/read/reader_parts.hpp"
#include "kernels/columns/columns.hpp"

namespace sluice {
namespace {

std::size_t read_material_of(TomlTable& table) {
    std::vector<std::string> names;
    for (const Material& material : table.scene().materials) names.push_back(material.name);
    return table.get("material").name(names);
}

/// Rows [t, x, y] or [t, x, y, z] with rising t.
void read_motion_table(const TomlValue& value, Motion& motion) {
    const auto columns = static_cast<std::size_t>(value.scene().dimension) + 1;
    const std::string expected = fmt::format("an array of rows of {} numbers, time first", columns);
    for (const TomlValue& row : value.items()) {
        const std::vector<TomlValue> numbers = row.items(expected);
        if (numbers.size() != columns) row.reject(expected);
        const double t = numbers[0].number();
        if (!motion.time.empty() && !(t > motion.time.back()))
            row.fail(fmt::format("found t = {} s after {} s, expected rising times", t, motion.time.back()));
        motion.time.push_back(t);
        Point place{};
        for (std::size_t k = 1; k < columns; ++k) place[k - 1] = numbers[k].number();
        motion.place.push_back(place);
    }
    if (motion.time.size() < 2) value.fail("found fewer than two rows, expected two or more");
}

Motion read_motion(const TomlValue& value) {
    Motion motion;
    TomlTable table(value);
    const TomlValue formulas = table.get("displacement"), rows = table.get("table");
    if (formulas && rows) rows.fail("found it beside displacement, expected one of the two");
    if (!formulas && !rows) table.fail("found neither displacement nor table, expected one of the two");
    if (formulas) motion.displacement = read_formulas(formulas);
    if (rows) read_motion_table(rows, motion);
    table.finish();
    return motion;
}

void read_free_surface(const TomlValue& value, MaterialKind kind, Body& body) {
    if (kind == MaterialKind::solid) value.fail("found a free surface of a solid, expected it for fluids only");
    if (value.scene().gravity == Point{})
        value.fail("found a free surface without gravity, expected gravity in the scene");
    body.hydrostatic_surface = value.number();
}

Body read_body(TomlTable& table, const std::string& name) {
    check_name(table, name);
    Body body;
    body.name = name;
    body.material = read_material_of(table);
    body.shape = read_shape(table.get("shape"));
    body.spacing = read_spacing(table);
    const MaterialKind kind = table.scene().materials[body.material].kind;
    if (const auto clamp = table.get("clamp")) {
        if (kind == MaterialKind::fluid) clamp.fail("found a clamp on a fluid, expected it for solids only");
        body.clamp = read_shape(clamp);
    }
    if (const auto surface = table.get("hydrostatic_surface")) read_free_surface(surface, kind, body);
    if (const auto velocity = table.get("velocity")) body.velocity = read_formulas(velocity);
    if (const auto pressure = table.get("pressure")) {
        if (kind == MaterialKind::solid) pressure.fail("found a pressure of a solid, expected it for fluids only");
        body.pressure = read_formula(pressure);
    }
    table.finish();
    return body;
}

/// Each particle names its body or wall in a column of numbers.
void check_count(TomlTable& all, const char* what) {
    const std::vector<std::string> names = all.keys();
    if (names.size() <= most_numbers) return;
    all.get(names[most_numbers])
        .fail(fmt::format("found {} {}, expected {} at the most", names.size(), what, most_numbers));
}

void read_mirror(TomlTable& table, Wall& wall) {
    wall.point = table.get("point").point();
    const TomlValue normal = table.get("normal");
    wall.normal = normal.point();
    const double length = std::hypot(wall.normal[0], wall.normal[1], wall.normal[2]);
    if (!(length > 0)) normal.fail("found a vector of length 0, expected a direction into the fluid");
    for (double& component : wall.normal) component /= length;
}

void read_fixed(TomlTable& table, Wall& wall) {
    wall.shape = read_shape(table.get("shape"));
    wall.spacing = read_spacing(table);
    if (const auto motion = table.get("motion")) wall.motion = read_motion(motion);
    if (const auto v = table.get("condition")) wall.condition = v.choice<WallCondition>();
}

Wall read_wall(TomlTable& table, const std::string& name) {
    check_name(table, name);
    Wall wall;
    wall.name = name;
    wall.kind = table.get("kind").choice<WallKind>();
    switch (wall.kind) {
        case WallKind::mirror:
            read_mirror(table, wall);
            break;
        case WallKind::fixed:
            read_fixed(table, wall);
            break;
    }
    table.finish();
    return wall;
}

}  // namespace

Formula read_formula(const TomlValue& value) {
    const Formula formula = value.node()->is_number() ? fmt::format("{}", value.number()) : value.text();
    CompiledFormula(value.scene(), value.path(), formula, value.key().value.variables);
    return formula;
}

std::array<Formula, 3> read_formulas(const TomlValue& value) {
    const std::vector<TomlValue> components = value.items();
    if (components.size() != static_cast<std::size_t>(value.scene().dimension)) value.reject();
    std::array<Formula, 3> formulas;
    for (std::size_t k = 0; k < components.size(); ++k) formulas[k] = read_formula(components[k]);
    return formulas;
}

double read_spacing(TomlTable& table) {
    const TomlValue spacing = table.get("spacing"), ratio = table.get("spacing_ratio");
    if (spacing && ratio) ratio.fail("found it beside spacing, expected one of the two");
    if (ratio) return ratio.number() * table.scene().method.spacing;
    return spacing ? spacing.number() : table.scene().method.spacing;
}

void check_name(const TomlTable& table, const std::string& name) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
    if (name.empty() || name.find_first_not_of(letters) != std::string::npos)
        table.fail(fmt::format("found the name \"{}\", expected letters, digits, _ and -", name));
}

void read_bodies(TomlTable& root) {
    const TomlValue value = root.get("bodies");
    if (!value) value.reject("a table of one body or more");
    TomlTable all(value);
    check_count(all, "bodies");
    for (const std::string& name : all.keys()) {
        TomlTable table(all.get(name));
        root.scene().bodies.push_back(read_body(table, name));
    }
    if (root.scene().bodies.empty()) all.fail("found no body, expected one or more");
}

void read_walls(TomlTable& root) {
    const TomlValue value = root.get("walls");
    if (!value) return;
    TomlTable all(value);
    check_count(all, "walls");
    for (const std::string& name : all.keys()) {
        TomlTable table(all.get(name));
        root.scene().walls.push_back(read_wall(table, name));
    }
}

}  // namespace sluice
