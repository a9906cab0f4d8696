#include "engine/view/frame_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/errors.hpp"
#include "engine/view/drawing.hpp"
#include "engine/view/particle_raster.hpp"
#include "engine/view/rulers.hpp"

namespace sluice {
namespace {

/// Diameters over spacings, as the page's. Discs of √2 spacings cover the plane of a square lattice without a gap,
/// which reads as water; balls need no more than to touch.
constexpr double overlap(int dimension) { return dimension == 2 ? 1.42 : 1.1; }

/// Lengths in pixels of a picture 720 pixels high, and what they become in another.
struct Layout {
    explicit Layout(const PictureStyle& style) : unit(style.height / 720.0), width(style.width), height(style.height) {
        box = {62 * unit, 60 * unit, width - 28 * unit, height - 118 * unit};
        frame = {box.left - 10 * unit, box.top - 10 * unit, box.right + 10 * unit, box.bottom + 10 * unit};
    }
    double unit, width, height;
    PictureBox box;    ///< that the particles fill
    PictureBox frame;  ///< that they may reach
};

std::string words_of(const std::string& field) {
    std::string words = field == "von_mises" ? "von Mises stress" : field;
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

void draw_planes(Drawing& drawing, const Projection& to, const RunFolder& run, const Palette& palette) {
    constexpr double far = 1e4;  // beyond any picture [pixels]
    for (const WallPlane& plane : run.planes) {
        const Point p = to(plane.point);
        const double dx = plane.normal[1] * far, dy = plane.normal[0] * far;
        drawing.line(p[0] - dx, p[1] - dy, p[0] + dx, p[1] + dy, palette.plain[2], 1.5);
    }
}

void draw_box(Drawing& drawing, const Projection& to, const Projection::Bounds& bounds, const Palette& palette) {
    const auto corner = [&](unsigned c) {
        Point p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = c >> k & 1U ? bounds[k].second : bounds[k].first;
        return to(p);
    };
    for (unsigned c = 0; c < 8; ++c)
        for (const unsigned axis : {1U, 2U, 4U}) {
            if (c & axis) continue;
            const Point a = corner(c), b = corner(c | axis);
            drawing.line(a[0], a[1], b[0], b[1], palette.line, 1.5);
        }
}

bool is_in(const PictureBox& box, const Point& p) {
    return p[0] > box.left && p[0] < box.right && p[1] > box.top && p[1] < box.bottom;
}

std::vector<Sprite> sprites_of(const StoredFrame& frame, const RunFolder& run, const Projection& to,
                               const PictureStyle& style) {
    const PictureBox limits = Layout(style).frame;
    const Palette palette = palette_of(style.theme);
    const std::vector<std::uint32_t> group = run.group_of(frame.table);
    const std::vector<NumberColumn> columns = field_columns(frame.table, run.dimension);
    std::array<const NumberColumn*, 3> shown{};
    for (std::size_t m = 0; m < shown.size(); ++m)
        for (const NumberColumn& column : columns)
            if (column.name == style.colors[m].field) shown[m] = &column;
    std::vector<Sprite> sprites;
    sprites.reserve(frame.table.particles);
    for (std::size_t i = 0; i < frame.table.particles; ++i) {
        const float* x = &frame.table.points[3 * i];
        const Point p = to({x[0], x[1], x[2]});
        if (!is_in(limits, p)) continue;
        const std::size_t m = std::min<std::size_t>(frame.table.medium[i], 2);
        const MediumColors& colors = style.colors[m];
        const float value = shown[m] ? (*shown[m])[i] : NAN;
        // In 2D all lie in one plane; the later are seen.
        const float near = run.dimension == 3 ? static_cast<float>(p[2]) : 0.0F;
        sprites.push_back(
            {static_cast<float>(p[0]), static_cast<float>(p[1]),
             static_cast<float>(0.5 * overlap(run.dimension) * run.groups[group[i]].spacing * to.pixels_per_metre()),
             near,
             std::isfinite(value) ? color_at(color_map(colors.map), (value - colors.low) / (colors.high - colors.low))
                                  : palette.plain[shown[m] ? 2 : m]});
    }
    return sprites;
}

void draw_legend(Drawing& drawing, const MediumColors& colors, double left, const Layout& at, const Palette& palette) {
    const double width = 300 * at.unit, top = at.height - 46 * at.unit, size = 13 * at.unit;
    const auto [unit, factor] =
        shown_unit(field_unit(colors.field), std::max(std::abs(colors.low), std::abs(colors.high)));
    drawing.text(left, top - 7 * at.unit, words_of(colors.field) + (unit.empty() ? "" : " [" + unit + "]"), size,
                 palette.ink);
    drawing.gradient({left, top, left + width, top + 12 * at.unit}, color_map(colors.map));
    for (int k = 0; k <= 4; ++k) {
        const double part = k / 4.0;
        const TextSide side = k == 0 ? TextSide::left : k == 4 ? TextSide::right : TextSide::middle;
        drawing.text(left + part * width, top + 28 * at.unit,
                     with_minus(fmt::format("{:.3g}", factor * (colors.low + part * (colors.high - colors.low)))), size,
                     palette.muted, side);
    }
}

void draw_words(Drawing& drawing, const StoredFrame& frame, const RunFolder& run, const PictureStyle& style,
                const Layout& at) {
    const Palette palette = palette_of(style.theme);
    drawing.text(28 * at.unit, 36 * at.unit, run.title, 20 * at.unit, palette.ink);
    drawing.text(at.width - 28 * at.unit, 36 * at.unit, fmt::format("t = {:.4f} s", frame.time), 20 * at.unit,
                 palette.ink, TextSide::right);
    double left = 28 * at.unit;
    for (const MediumColors& colors : style.colors) {
        if (colors.field.empty()) continue;
        draw_legend(drawing, colors, left, at, palette);
        left += 360 * at.unit;
    }
}

}  // namespace

MediumColors suited_colors(const FieldRanges& ranges, const std::string& field, FrameMedium medium) {
    const auto range = ranges.of(field, medium);
    if (!range) throw RunReadError(fmt::format("field \"{}\": no particle of this medium has a value", field));
    double low = range->low, high = range->high;
    if (!(high > low)) low = range->least, high = std::max(range->most, range->least + 1e-9);
    if (is_signed_range(low, high)) {
        const double size = std::max(-low, high);
        return {field, "coolwarm", -size, size};
    }
    if (low > 0 && low < 0.1 * high) low = 0;  // as the page: a speed starts at rest
    return {field, medium == FrameMedium::solid ? "plasma" : "viridis", low, high};
}

std::string frame_picture(const StoredFrame& frame, const RunFolder& run, const Projection::Bounds& bounds,
                          const PictureStyle& style) {
    const Layout at(style);
    const Palette palette = palette_of(style.theme);
    Projection::Bounds shown = bounds;
    if (style.window)
        for (std::size_t k = 0; k < 2; ++k) shown[k] = (*style.window)[k];
    const Projection to =
        run.dimension == 2 ? Projection::flat(shown, at.box) : Projection::oblique(shown, at.box, run.up, style.angles);
    Drawing drawing(style.width, style.height, palette.page);
    drawing.clip(at.frame);
    if (run.dimension == 2)
        draw_planes(drawing, to, run, palette);
    else
        draw_box(drawing, to, bounds, palette);
    drawing.unclip();
    ParticleRaster raster(style.width, style.height);
    raster.draw(sprites_of(frame, run, to, style), run.dimension == 2 ? Shading::flat : Shading::ball);
    raster.blend_into(drawing.pixels(), drawing.stride());
    drawing.pixels_changed();
    if (run.dimension == 2) draw_rulers(drawing, to, at.box, at.unit, palette);
    draw_words(drawing, frame, run, style, at);
    return drawing.png();
}

}  // namespace sluice
