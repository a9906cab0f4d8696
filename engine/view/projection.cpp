#include "engine/view/projection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sluice {
namespace {

Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point mix(double a, const Point& x, double b, const Point& y, double c, const Point& z) {
    return {a * x[0] + b * y[0] + c * z[0], a * x[1] + b * y[1] + c * z[1], a * x[2] + b * y[2] + c * z[2]};
}

/// The axis that points most along a direction.
Point nearest_axis(const Point& direction) {
    std::size_t k = 0;
    for (std::size_t j = 1; j < 3; ++j)
        if (std::abs(direction[j]) > std::abs(direction[k])) k = j;
    Point axis{};
    axis[k] = direction[k] < 0 ? -1 : 1;
    return axis;
}

}  // namespace

Projection Projection::flat(const Bounds& bounds, const PictureBox& box) {
    Projection made;
    made.fit(bounds, box);
    return made;
}

Projection Projection::oblique(const Bounds& bounds, const PictureBox& box, const Point& up, ViewAngles angles) {
    const double a = angles.azimuth * std::numbers::pi / 180, e = angles.elevation * std::numbers::pi / 180;
    const Point top = nearest_axis(up);
    const Point side = top[0] != 0 ? Point{0, 1, 0} : Point{1, 0, 0};
    const Point front = cross(side, top);
    Projection made;
    made.right_ = mix(std::cos(a), side, -std::sin(a), front, 0, top);
    made.up_ = mix(-std::sin(a) * std::sin(e), side, -std::cos(a) * std::sin(e), front, std::cos(e), top);
    made.to_eye_ = mix(std::sin(a) * std::cos(e), side, std::cos(a) * std::cos(e), front, std::sin(e), top);
    made.fit(bounds, box);
    return made;
}

void Projection::fit(const Bounds& bounds, const PictureBox& box) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (unsigned corner = 0; corner < 8; ++corner) {
        Point c;
        for (std::size_t k = 0; k < 3; ++k) c[k] = corner >> k & 1U ? bounds[k].second : bounds[k].first;
        const double at[2] = {dot(right_, c), dot(up_, c)};
        for (int k = 0; k < 2; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
    }
    const double least = 1e-9;  // a run of one particle has no extent
    scale_ = std::min((box.right - box.left) / std::max(least, high[0] - low[0]),
                      (box.bottom - box.top) / std::max(least, high[1] - low[1]));
    x_ = 0.5 * (box.left + box.right) - scale_ * 0.5 * (low[0] + high[0]);
    y_ = 0.5 * (box.top + box.bottom) + scale_ * 0.5 * (low[1] + high[1]);
}

Point Projection::operator()(const Point& place) const {
    return {x_ + scale_ * dot(right_, place), y_ - scale_ * dot(up_, place), dot(to_eye_, place)};
}

}  // namespace sluice
