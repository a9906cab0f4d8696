// Regions of space: box, ball, cylinder, polygon, extrusion, and their unions and differences.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace sluice {

/// A position; z = 0 in 2D. [m]
using Point = std::array<double, 3>;

struct Bounds {
    Point min{};
    Point max{};
};

/// An immutable closed region.
class Shape {
  public:
    virtual ~Shape() = default;
    virtual bool contains(const Point& p) const = 0;
    virtual Bounds bounds() const = 0;
};
using ShapePtr = std::shared_ptr<const Shape>;

/// The ends of a stretch along one axis. [m]
struct Interval {
    double from = 0;
    double to = 0;
};

ShapePtr make_box(const Point& min, const Point& max);
/// A disc in 2D, a ball in 3D.
ShapePtr make_ball(const Point& centre, double radius);
/// A straight circular cylinder with flat ends, along the line between their centres.
ShapePtr make_cylinder(const Point& from, const Point& to, double radius);
/// A simple polygon in the xy-plane, vertices in order, closed by itself.
ShapePtr make_polygon(std::vector<Point> vertices);
/// The two axes across a given one, in the order x, y, z: the plane of an extrusion's polygon.
std::array<std::size_t, 2> axes_across(std::size_t axis);
/// A simple polygon drawn out along an axis (0, 1, 2 = x, y, z); its vertices' first two components are coordinates
/// along `axes_across(axis)`.
ShapePtr make_extrusion(std::vector<Point> polygon, std::size_t axis, const Interval& along);
ShapePtr make_union(std::vector<ShapePtr> parts);
/// What is in `base` and in none of `cut`.
ShapePtr make_difference(ShapePtr base, std::vector<ShapePtr> cut);

}  // namespace sluice
