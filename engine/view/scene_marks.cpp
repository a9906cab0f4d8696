#include "engine/view/scene_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sluice {
namespace {

constexpr double dash = 6, mark_text_size = 13;  // [pixels]

void draw_edge(Drawing& drawing, const MarkPlace& at, const Point& a, const Point& b) {
    const Point p = at.to(a), q = at.to(b);
    drawing.line(p[0], p[1], q[0], q[1], at.palette.line, 1.5);
}

Point corner_of(const Projection::Bounds& bounds, unsigned corner) {
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = corner >> k & 1U ? bounds[k].second : bounds[k].first;
    return p;
}

/// visit(a, b) for the twelve edges of a box.
template <class Visit>
void for_each_edge(const Projection::Bounds& bounds, Visit visit) {
    for (unsigned c = 0; c < 8; ++c)
        for (const unsigned axis : {1U, 2U, 4U})
            if (!(c & axis)) visit(corner_of(bounds, c), corner_of(bounds, c | axis));
}

/// A line from side to side, with short strokes behind it.
void draw_hatched(Drawing& drawing, const MarkPlace& at, const Wall& wall) {
    constexpr double far = 4000, step = 9, stroke = 8;  // [pixels]
    const Point p = at.to(wall.point);
    // The picture's y runs downwards.
    const double along_x = wall.normal[1], along_y = wall.normal[0], back_x = -wall.normal[0], back_y = wall.normal[1];
    drawing.line(p[0] - far * along_x, p[1] - far * along_y, p[0] + far * along_x, p[1] + far * along_y,
                 at.palette.muted, 2);
    for (double s = -far; s < far; s += step) {
        const double x = p[0] + s * along_x, y = p[1] + s * along_y;
        drawing.line(x, y, x + stroke * (back_x + 0.5 * along_x), y + stroke * (back_y + 0.5 * along_y),
                     at.palette.muted);
    }
}

/// Where a plane cuts the edges of the box that is shown, joined in turn.
void draw_outline(Drawing& drawing, const MarkPlace& at, const Wall& wall) {
    std::vector<Point> cuts;
    // Planes often are sides of the box; theirs count as below, whatever rounding makes of them.
    constexpr double least = 1e-9;
    const auto height = [&](const Point& p) { return dot(p, wall.normal) - dot(wall.point, wall.normal) - least; };
    for_each_edge(at.bounds, [&](const Point& a, const Point& b) {
        const double from = height(a), to = height(b);
        if ((from < 0) == (to < 0)) return;
        const double part = from / (from - to);
        cuts.push_back({a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])});
    });
    if (cuts.size() < 3) return;
    // In turn about their middle, as seen along the normal.
    Point middle{};
    for (const Point& c : cuts)
        for (std::size_t k = 0; k < 3; ++k) middle[k] += c[k] / static_cast<double>(cuts.size());
    const std::size_t across = std::abs(wall.normal[0]) < 0.7 ? 0 : 1;
    Point u{}, v{};
    u[across] = 1;
    for (std::size_t k = 0; k < 3; ++k) u[k] -= wall.normal[across] * wall.normal[k];
    for (std::size_t k = 0; k < 3; ++k)
        v[k] = wall.normal[(k + 1) % 3] * u[(k + 2) % 3] - wall.normal[(k + 2) % 3] * u[(k + 1) % 3];
    const auto angle = [&](const Point& c) {
        const Point d{c[0] - middle[0], c[1] - middle[1], c[2] - middle[2]};
        return std::atan2(dot(d, v), dot(d, u));
    };
    std::sort(cuts.begin(), cuts.end(), [&](const Point& a, const Point& b) { return angle(a) < angle(b); });
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        const Point a = at.to(cuts[k]), b = at.to(cuts[(k + 1) % cuts.size()]);
        drawing.line(a[0], a[1], b[0], b[1], at.palette.muted, 1.5);
    }
}

/// Names that keep clear of each other: one that would cover another goes above it.
class Labels {
  public:
    Labels(Drawing& drawing, const MarkPlace& at) : drawing_(drawing), at_(at) {}

    void add(double x, double y, const std::string& name, TextSide side) {
        const double width = letter_width * mark_text_size * static_cast<double>(name.size());
        const double left = x - part_before(side) * width;
        PictureBox box{left, y - mark_text_size, left + width, y};
        const auto covers = [&](const PictureBox& other) {
            return box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom;
        };
        while (std::any_of(taken_.begin(), taken_.end(), covers)) box.top -= 2, box.bottom -= 2;
        taken_.push_back(box);
        drawing_.label(x, box.bottom, name, mark_text_size, at_.palette.ink, at_.palette.page, side);
    }

  private:
    static constexpr double letter_width = 0.62;  // of the size, in the mean of sans-serif faces
    Drawing& drawing_;
    const MarkPlace& at_;
    std::vector<PictureBox> taken_;
};

/// A level is taken along the vertical through a place.
void draw_level(Drawing& drawing, const MarkPlace& at, const Probe& probe, Labels& labels) {
    Point low = probe.at, high = probe.at;
    low[1] = at.bounds[1].first, high[1] = at.bounds[1].second;
    const Point a = at.to(low), b = at.to(high);
    drawing.dashed_line(a[0], a[1], b[0], b[1], at.palette.ink, dash / 2);
    labels.add(b[0], b[1] - 4, probe.name, TextSide::middle);
}

}  // namespace

void draw_planes(Drawing& drawing, const MarkPlace& at) {
    if (at.scene.dimension == 3)
        for_each_edge(at.bounds, [&](const Point& a, const Point& b) { draw_edge(drawing, at, a, b); });
    for (const Wall& wall : at.scene.walls) {
        if (wall.kind != WallKind::mirror) continue;
        if (at.scene.dimension == 2)
            draw_hatched(drawing, at, wall);
        else
            draw_outline(drawing, at, wall);
    }
}

void draw_periodic_sides(Drawing& drawing, const MarkPlace& at) {
    Projection::Bounds box = at.bounds;
    for (std::size_t k = 0; k < 3; ++k)
        if (at.scene.periodic[k]) box[k] = *at.scene.periodic[k];
    const auto draw = [&](const Point& a, const Point& b) {
        const Point p = at.to(a), q = at.to(b);
        drawing.dashed_line(p[0], p[1], q[0], q[1], at.palette.ink, dash);
    };
    const auto axes = static_cast<std::size_t>(at.scene.dimension);
    for (std::size_t k = 0; k < axes; ++k) {
        if (!at.scene.periodic[k]) continue;
        for (const double side : {box[k].first, box[k].second}) {
            Projection::Bounds face = box;
            face[k] = {side, side};
            if (axes == 2) face[2] = {0, 0};
            for_each_edge(face, draw);
        }
    }
}

void draw_marker(Drawing& drawing, const Point& p, const Palette& palette) {
    constexpr double radius = 5;  // [pixels]
    for (const auto& [color, width] : {std::pair(palette.page, 4.0), std::pair(palette.ink, 1.5)}) {
        drawing.circle(p[0], p[1], radius, color, width);
        drawing.line(p[0] - radius, p[1], p[0] + radius, p[1], color, width);
        drawing.line(p[0], p[1] - radius, p[0], p[1] + radius, color, width);
    }
}

void draw_probes(Drawing& drawing, const MarkPlace& at) {
    constexpr double gap = 9;  // [pixels]
    Labels labels(drawing, at);
    for (const Probe& probe : at.scene.probes) {
        if (probe.kind == ProbeKind::water_level) draw_level(drawing, at, probe, labels);
        if (!probe.has_place() || probe.kind == ProbeKind::water_level) continue;
        const Point p = at.to(probe.at);
        draw_marker(drawing, p, at.palette);
        const bool right = p[0] < 0.5 * (at.box.left + at.box.right);  // where the picture has room
        labels.add(right ? p[0] + gap : p[0] - gap, p[1] - gap, probe.name, right ? TextSide::left : TextSide::right);
    }
}

}  // namespace sluice
