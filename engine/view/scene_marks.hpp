// Walls, probes and periodic sides in the picture of a scene.
#pragma once

#include "engine/scene/scene.hpp"
#include "engine/view/drawing.hpp"
#include "engine/view/palette.hpp"

namespace sluice {

/// What marks are drawn with.
struct MarkPlace {
    const Scene& scene;
    const Projection& to;
    const Projection::Bounds& bounds;  ///< of what is shown [m]
    PictureBox box;                    ///< that it fills
    Palette palette;
};

/// A cross in a ring, about a place in the picture.
void draw_marker(Drawing& drawing, const Point& place, const Palette& palette);

/// Behind the particles: mirror walls, hatched on their dry side, and the box that is shown in 3D.
void draw_planes(Drawing& drawing, const MarkPlace& at);
/// Before them: sides of the periodic box, and probes with their names.
void draw_periodic_sides(Drawing& drawing, const MarkPlace& at);
void draw_probes(Drawing& drawing, const MarkPlace& at);

}  // namespace sluice
