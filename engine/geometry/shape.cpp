#include "engine/geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/geometry/cavity.hpp"

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

class Ball : public Shape {
  public:
    Ball(const Point& centre, double radius) : centre_(centre), radius_(radius) {}
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

class Cylinder : public Shape {
  public:
    Cylinder(const Point& from, const Point& to, double radius) : from_(from), to_(to), radius_(radius) {
        for (std::size_t k = 0; k < 3; ++k) direction_[k] = to[k] - from[k];
        length_ = std::hypot(direction_[0], direction_[1], direction_[2]);
        for (double& component : direction_) component /= length_;
        slack_ = edge_tolerance * std::max(length_, 2 * radius);
    }
    bool contains(const Point& p) const override {
        Point r;
        for (std::size_t k = 0; k < 3; ++k) r[k] = p[k] - from_[k];
        const double along = r[0] * direction_[0] + r[1] * direction_[1] + r[2] * direction_[2];
        if (along < -slack_ || along > length_ + slack_) return false;
        for (std::size_t k = 0; k < 3; ++k) r[k] -= along * direction_[k];
        return std::hypot(r[0], r[1], r[2]) <= radius_ + slack_;
    }
    /// A disc of radius R across the unit vector a reaches R sqrt(1 − a_k²) along axis k.
    Bounds bounds() const override {
        Bounds b;
        for (std::size_t k = 0; k < 3; ++k) {
            const double reach = radius_ * std::sqrt(std::max(0.0, 1 - direction_[k] * direction_[k]));
            b.min[k] = std::min(from_[k], to_[k]) - reach;
            b.max[k] = std::max(from_[k], to_[k]) + reach;
        }
        return b;
    }

  private:
    Point from_, to_, direction_{};
    double radius_, length_ = 0, slack_ = 0;
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

class Extrusion : public Shape {
  public:
    Extrusion(std::vector<Point> polygon, std::size_t axis, const Interval& along)
        : polygon_(std::move(polygon)), axis_(axis), along_(along) {
        slack_ = edge_tolerance * (along.to - along.from);
    }
    bool contains(const Point& p) const override {
        if (p[axis_] < along_.from - slack_ || p[axis_] > along_.to + slack_) return false;
        const auto [u, v] = axes_across(axis_);
        return polygon_.contains({p[u], p[v], 0});
    }
    Bounds bounds() const override {
        const Bounds flat = polygon_.bounds();
        const auto [u, v] = axes_across(axis_);
        Bounds b;
        b.min[axis_] = along_.from, b.min[u] = flat.min[0], b.min[v] = flat.min[1];
        b.max[axis_] = along_.to, b.max[u] = flat.max[0], b.max[v] = flat.max[1];
        return b;
    }

  private:
    Polygon polygon_;
    std::size_t axis_;
    Interval along_;
    double slack_;
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
    Bounds cavity() const {
        if (cut_.empty()) return bounds();
        Bounds all = cut_[0]->bounds();
        for (const ShapePtr& part : cut_) {
            const Bounds b = part->bounds();
            for (std::size_t k = 0; k < 3; ++k) {
                all.min[k] = std::min(all.min[k], b.min[k]);
                all.max[k] = std::max(all.max[k], b.max[k]);
            }
        }
        return all;
    }

  private:
    ShapePtr base_;
    std::vector<ShapePtr> cut_;
};

}  // namespace

Bounds cavity_of(const Shape& shape) {
    const auto* difference = dynamic_cast<const Difference*>(&shape);
    return difference ? difference->cavity() : shape.bounds();
}

ShapePtr make_box(const Point& min, const Point& max) { return std::make_shared<Box>(min, max); }

ShapePtr make_ball(const Point& centre, double radius) { return std::make_shared<Ball>(centre, radius); }

ShapePtr make_cylinder(const Point& from, const Point& to, double radius) {
    return std::make_shared<Cylinder>(from, to, radius);
}

ShapePtr make_polygon(std::vector<Point> vertices) { return std::make_shared<Polygon>(std::move(vertices)); }

std::array<std::size_t, 2> axes_across(std::size_t axis) {
    constexpr std::array<std::array<std::size_t, 2>, 3> across{{{1, 2}, {0, 2}, {0, 1}}};
    return across[axis];
}

ShapePtr make_extrusion(std::vector<Point> polygon, std::size_t axis, const Interval& along) {
    return std::make_shared<Extrusion>(std::move(polygon), axis, along);
}

ShapePtr make_union(std::vector<ShapePtr> parts) { return std::make_shared<Union>(std::move(parts)); }

ShapePtr make_difference(ShapePtr base, std::vector<ShapePtr> cut) {
    return std::make_shared<Difference>(std::move(base), std::move(cut));
}

}  // namespace sluice
