#include "engine/geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sluice {
namespace {

// Lattice sites often lie exactly on an edge, give or take a rounding error. A closed region keeps all of them or, when
// it is cut out, none, so every edge is widened by this share of the shape's size: far above rounding, far below a
// spacing.
constexpr double edge_tolerance = 1e-10;

class Box : public Shape {
  public:
    Box(const Point& min, const Point& max) : bounds_{min, max} {
        for (std::size_t k = 0; k < 3; ++k) slack_ = std::max(slack_, edge_tolerance * (max[k] - min[k]));
    }
    bool contains(const Point& p) const override {
        for (std::size_t k = 0; k < 3; ++k)
            if (p[k] < bounds_.min[k] - slack_ || p[k] > bounds_.max[k] + slack_) return false;
        return true;
    }
    Bounds bounds() const override { return bounds_; }

  private:
    Bounds bounds_;
    double slack_ = 0;
};

class Circle : public Shape {
  public:
    Circle(const Point& centre, double radius) : centre_(centre), radius_(radius) {}
    bool contains(const Point& p) const override {
        const double distance = std::hypot(p[0] - centre_[0], p[1] - centre_[1], p[2] - centre_[2]);
        return distance <= radius_ * (1 + edge_tolerance);
    }
    Bounds bounds() const override {
        Bounds b{centre_, centre_};
        for (std::size_t k = 0; k < 3; ++k) {
            b.min[k] -= radius_;
            b.max[k] += radius_;
        }
        return b;
    }

  private:
    Point centre_;
    double radius_;
};

Bounds united(const Bounds& a, const Bounds& b) {
    Bounds u;
    for (std::size_t k = 0; k < 3; ++k) {
        u.min[k] = std::min(a.min[k], b.min[k]);
        u.max[k] = std::max(a.max[k], b.max[k]);
    }
    return u;
}

/// Distance of p from the segment ab in the xy-plane.
double segment_distance(const Point& p, const Point& a, const Point& b) {
    const double ex = b[0] - a[0], ey = b[1] - a[1];
    const double length2 = ex * ex + ey * ey;
    const double along = length2 > 0 ? ((p[0] - a[0]) * ex + (p[1] - a[1]) * ey) / length2 : 0;
    const double t = std::clamp(along, 0.0, 1.0);
    return std::hypot(p[0] - a[0] - t * ex, p[1] - a[1] - t * ey);
}

class Polygon : public Shape {
  public:
    explicit Polygon(std::vector<Point> vertices) : vertices_(std::move(vertices)) {
        bounds_ = {vertices_.front(), vertices_.front()};
        for (const Point& v : vertices_) bounds_ = united(bounds_, {v, v});
        slack_ = edge_tolerance * std::max(bounds_.max[0] - bounds_.min[0], bounds_.max[1] - bounds_.min[1]);
    }
    /// Even-odd rule along a ray to the right; a point on an edge belongs to the polygon.
    bool contains(const Point& p) const override {
        bool inside = false;
        for (std::size_t i = 0, j = vertices_.size() - 1; i < vertices_.size(); j = i++) {
            const Point &a = vertices_[i], &b = vertices_[j];
            if (segment_distance(p, a, b) <= slack_) return true;
            if ((a[1] > p[1]) == (b[1] > p[1])) continue;
            if (p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1])) inside = !inside;
        }
        return inside;
    }
    Bounds bounds() const override { return bounds_; }

  private:
    std::vector<Point> vertices_;
    Bounds bounds_;
    double slack_ = 0;
};

class Union : public Shape {
  public:
    explicit Union(std::vector<ShapePtr> parts) : parts_(std::move(parts)) {}
    bool contains(const Point& p) const override {
        return std::any_of(parts_.begin(), parts_.end(), [&](const ShapePtr& s) { return s->contains(p); });
    }
    Bounds bounds() const override {
        Bounds all = parts_.front()->bounds();
        for (const ShapePtr& s : parts_) all = united(all, s->bounds());
        return all;
    }

  private:
    std::vector<ShapePtr> parts_;
};

class Difference : public Shape {
  public:
    Difference(ShapePtr base, std::vector<ShapePtr> cut) : base_(std::move(base)), cut_(std::move(cut)) {}
    bool contains(const Point& p) const override {
        return base_->contains(p) &&
               std::none_of(cut_.begin(), cut_.end(), [&](const ShapePtr& s) { return s->contains(p); });
    }
    Bounds bounds() const override { return base_->bounds(); }

  private:
    ShapePtr base_;
    std::vector<ShapePtr> cut_;
};

}  // namespace

ShapePtr make_box(const Point& min, const Point& max) { return std::make_shared<Box>(min, max); }

ShapePtr make_circle(const Point& centre, double radius) { return std::make_shared<Circle>(centre, radius); }

ShapePtr make_polygon(std::vector<Point> vertices) { return std::make_shared<Polygon>(std::move(vertices)); }

ShapePtr make_union(std::vector<ShapePtr> parts) { return std::make_shared<Union>(std::move(parts)); }

ShapePtr make_difference(ShapePtr base, std::vector<ShapePtr> cut) {
    return std::make_shared<Difference>(std::move(base), std::move(cut));
}

}  // namespace sluice
