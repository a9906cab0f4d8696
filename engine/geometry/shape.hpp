// Regions of space: box, circle, polygon, and their unions and differences.
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

ShapePtr make_box(const Point& min, const Point& max);
/// A disc in 2D, a ball in 3D.
ShapePtr make_circle(const Point& centre, double radius);
/// A simple polygon in the xy-plane, vertices in order, closed by itself.
ShapePtr make_polygon(std::vector<Point> vertices);
ShapePtr make_union(std::vector<ShapePtr> parts);
/// What is in `base` and in none of `cut`.
ShapePtr make_difference(ShapePtr base, std::vector<ShapePtr> cut);

}  // namespace sluice
