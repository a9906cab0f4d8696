// From a place in space to a place in a picture: straight on in 2D, obliquely and without perspective in 3D.
#pragma once

#include <array>
#include <utility>

#include "engine/scene/scene.hpp"

namespace sluice {

struct PictureBox {
    double left = 0, top = 0, right = 0, bottom = 0;  ///< [pixels]
};

struct ViewAngles {
    double azimuth = 30, elevation = 20;  ///< as the page starts with [degrees]
};

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

class Projection {
  public:
    using Bounds = std::array<std::pair<double, double>, 3>;

    /// Shows `bounds` as large as the box allows.
    static Projection flat(const Bounds& bounds, const PictureBox& box);
    static Projection oblique(const Bounds& bounds, const PictureBox& box, const Point& up, ViewAngles angles);

    /// x and y in pixels from the upper left corner, z towards the viewer in metres.
    Point operator()(const Point& place) const;
    double pixels_per_metre() const { return scale_; }

  private:
    void fit(const Bounds& bounds, const PictureBox& box);

    Point right_{1, 0, 0}, up_{0, 1, 0}, to_eye_{0, 0, 1};
    double scale_ = 1, x_ = 0, y_ = 0;
};

}  // namespace sluice
