#include <fmt/format.h>

#include <array>
#include <utility>

#include "engine/geometry/simple_polygon.hpp"
#include "engine/scene/read/reader_parts.hpp"

namespace sluice {
namespace {

ShapePtr read_box(const TomlValue& value) {
    TomlTable table(value);
    const TomlValue min = table.get("min"), max = table.get("max");
    const Point low = min.point(), high = max.point();
    for (std::size_t k = 0; k < static_cast<std::size_t>(value.scene().dimension); ++k)
        if (!(low[k] < high[k]))
            max.fail(fmt::format("found {} = {}, expected more than min's {}", "xyz"[k], high[k], low[k]));
    table.finish();
    return make_box(low, high);
}

/// Circle and sphere.
ShapePtr read_ball(const TomlValue& value) {
    TomlTable table(value);
    const Point centre = table.get("centre").point();
    const double radius = table.get("radius").number();
    table.finish();
    return make_ball(centre, radius);
}

ShapePtr read_cylinder(const TomlValue& value) {
    TomlTable table(value);
    const TomlValue from = table.get("from"), to = table.get("to");
    const Point begin = from.point(), end = to.point();
    if (begin == end) to.fail("found the same point as from's, expected the centre of the other end");
    const double radius = table.get("radius").number();
    table.finish();
    return make_cylinder(begin, end, radius);
}

/// The vertices of a simple polygon in the plane of two axes.
std::vector<Point> read_vertices(const TomlValue& value, const std::array<std::size_t, 2>& axes) {
    const std::string pair = fmt::format("[{}, {}]", "xyz"[axes[0]], "xyz"[axes[1]]);
    std::vector<Point> vertices;
    for (const TomlValue& vertex : value.items("an array of vertices " + pair)) {
        const std::vector<TomlValue> numbers = vertex.items("2 numbers " + pair);
        if (numbers.size() != 2) vertex.reject("2 numbers " + pair);
        vertices.push_back({numbers[0].number(), numbers[1].number(), 0});
    }
    if (vertices.size() < 3)
        value.fail(fmt::format("found a polygon of {} vertices, expected 3 or more", vertices.size()));
    if (const auto crossing = find_crossing_edges(vertices))
        value.fail(
            fmt::format("found edges that meet (from vertex {} and from vertex {}, counted from 0), expected a "
                        "polygon that does not cross itself",
                        crossing->first, crossing->second));
    if (polygon_area(vertices) == 0) value.fail("found a polygon without area, expected vertices not on one line");
    return vertices;
}

ShapePtr read_polygon(const TomlValue& value) { return make_polygon(read_vertices(value, {0, 1})); }

ShapePtr read_extrusion(const TomlValue& value) {
    TomlTable table(value);
    const TomlValue vertices = table.get("polygon");
    const auto axis = static_cast<std::size_t>(table.get("axis").choice<Direction>());
    std::vector<Point> polygon = read_vertices(vertices, axes_across(axis));
    const TomlValue from = table.get("from"), to = table.get("to");
    const Interval along{from.number(), to.number()};
    if (!(along.from < along.to)) to.fail(fmt::format("found {}, expected more than from's {}", along.to, along.from));
    table.finish();
    return make_extrusion(std::move(polygon), axis, along);
}

std::vector<ShapePtr> read_shapes(const TomlValue& value) {
    std::vector<ShapePtr> shapes;
    for (const TomlValue& item : value.items("an array of shapes")) shapes.push_back(read_shape(item));
    return shapes;
}

ShapePtr read_union(const TomlValue& value) {
    std::vector<ShapePtr> parts = read_shapes(value);
    if (parts.empty()) value.fail("found no shape, expected one or more");
    return make_union(std::move(parts));
}

ShapePtr read_difference(const TomlValue& value) {
    std::vector<ShapePtr> shapes = read_shapes(value);
    if (shapes.size() < 2)
        value.fail(
            fmt::format("found {} shapes, expected two or more: the first and what is cut from it", shapes.size()));
    const ShapePtr base = shapes.front();
    shapes.erase(shapes.begin());
    return make_difference(base, std::move(shapes));
}

struct ShapeKind {
    const char* key;
    ShapePtr (*read)(const TomlValue&);
    int dimension = 0;         ///< 0 = both
    const char* instead = "";  ///< what to write in a scene of the other dimension
};
constexpr std::array<ShapeKind, 8> shape_kinds{{
    {"box", read_box},
    {"circle", read_ball, 2, "sphere"},
    {"polygon", read_polygon, 2, "extrusion = {polygon = [[x, y], ...], axis = \"z\", from = z0, to = z1}"},
    {"sphere", read_ball, 3, "circle"},
    {"cylinder", read_cylinder, 3, "circle, or box for one seen from its side"},
    {"extrusion", read_extrusion, 3, "polygon"},
    {"union", read_union},
    {"difference", read_difference},
}};

/// "one of box, circle, …", those that the scene's dimension has.
std::string known_shapes(int dimension) {
    std::string list;
    for (const ShapeKind& kind : shape_kinds)
        if (kind.dimension == 0 || kind.dimension == dimension)
            list += (list.empty() ? "one of " : ", ") + std::string(kind.key);
    return list;
}

/// A shape of the other dimension is answered with its counterpart.
void refuse_foreign(const TomlValue& value, const ShapeKind& kind) {
    if (!value.node()->as_table()->contains(kind.key)) return;
    TomlTable(value).get(kind.key).fail(fmt::format("found {} {} in a {}D scene, expected {}",
                                                    kind.key[0] == 'e' ? "an" : "a", kind.key, value.scene().dimension,
                                                    kind.instead));
}

}  // namespace

ShapePtr read_shape(const TomlValue& value) {
    const int dimension = value.scene().dimension;
    if (!value || !value.node()->is_table()) value.reject("a table with " + known_shapes(dimension));
    TomlTable table(value);
    ShapePtr shape;
    for (const ShapeKind& kind : shape_kinds) {
        if (kind.dimension != 0 && kind.dimension != dimension) {
            refuse_foreign(value, kind);
            continue;
        }
        const TomlValue found = table.get(kind.key);
        if (!found) continue;
        if (shape) found.fail("found a second shape, expected " + known_shapes(dimension));
        shape = kind.read(found);
    }
    table.finish();
    if (!shape) value.fail("found an empty table, expected " + known_shapes(dimension));
    return shape;
}

}  // namespace sluice
