#include <fmt/format.h>

#include <array>
#include <utility>

#include "engine/geometry/simple_polygon.hpp"
#include "engine/scene/reader_parts.hpp"

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

ShapePtr read_circle(const TomlValue& value) {
    TomlTable table(value);
    const Point centre = table.get("centre").point();
    const double radius = table.get("radius").number(positive);
    table.finish();
    return make_circle(centre, radius);
}

ShapePtr read_polygon(const TomlValue& value) {
    if (value.scene().dimension == 3)
        value.fail("found a polygon in a 3D scene, expected box, circle, union or difference");
    std::vector<Point> vertices;
    for (const TomlValue& vertex : value.items("an array of vertices [x, y]")) vertices.push_back(vertex.point());
    if (vertices.size() < 3)
        value.fail(fmt::format("found a polygon of {} vertices, expected 3 or more", vertices.size()));
    if (const auto crossing = find_crossing_edges(vertices))
        value.fail(
            fmt::format("found edges that meet (from vertex {} and from vertex {}, counted from 0), expected a "
                        "polygon that does not cross itself",
                        crossing->first, crossing->second));
    if (polygon_area(vertices) == 0) value.fail("found a polygon without area, expected vertices not on one line");
    return make_polygon(std::move(vertices));
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
};
constexpr std::array<ShapeKind, 5> shape_kinds{{{"box", read_box},
                                                {"circle", read_circle},
                                                {"polygon", read_polygon},
                                                {"union", read_union},
                                                {"difference", read_difference}}};

}  // namespace

ShapePtr read_shape(const TomlValue& value) {
    constexpr std::string_view expected = "one of box, circle, polygon, union, difference";
    if (!value || !value.node()->is_table()) value.reject("a table with " + std::string(expected));
    TomlTable table(value);
    ShapePtr shape;
    for (const ShapeKind& kind : shape_kinds) {
        const TomlValue found = table.get(kind.key);
        if (!found) continue;
        if (shape) found.fail("found a second shape, expected " + std::string(expected));
        shape = kind.read(found);
    }
    table.finish();
    if (!shape) value.fail("found an empty table, expected " + std::string(expected));
    return shape;
}

}  // namespace sluice
