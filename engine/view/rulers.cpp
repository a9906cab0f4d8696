#include "engine/view/rulers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sluice {

std::pair<std::string, double> shown_unit(std::string_view unit, double size) {
    if (unit == "m" && size < 0.5) return {"mm", 1e3};
    if (unit == "Pa" && size >= 1e6) return {"MPa", 1e-6};
    if (unit == "Pa" && size >= 1e3) return {"kPa", 1e-3};
    return {std::string(unit), 1};
}

std::string with_minus(const std::string& number) { return number.starts_with('-') ? "−" + number.substr(1) : number; }

double even_step(double least) {
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double k : {1.0, 2.0, 5.0})
        if (k * power >= least) return k * power;
    return 10 * power;
}

void draw_rulers(Drawing& drawing, const Projection& to, const PictureBox& box, double unit, const Palette& palette) {
    const double scale = to.pixels_per_metre(), step = even_step(90 * unit / scale);
    const auto [name, factor] = shown_unit("m", (box.right - box.left) / scale);
    const Point zero = to({0, 0, 0});
    const double size = 13 * unit;
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step * factor) + 1e-9)));
    const auto label = [&](double k) { return with_minus(fmt::format("{:.{}f}", k * step * factor + 0.0, decimals)); };
    const double base = box.bottom + 12 * unit, side = box.left - 14 * unit;
    for (double k = std::ceil((box.left - zero[0]) / scale / step); zero[0] + k * step * scale <= box.right; ++k) {
        const double x = zero[0] + k * step * scale;
        drawing.line(x, base, x, base + 5 * unit, palette.muted);
        drawing.text(x, base + 19 * unit, label(k), size, palette.muted, TextSide::middle);
    }
    for (double k = std::ceil((zero[1] - box.bottom) / scale / step); zero[1] - k * step * scale >= box.top; ++k) {
        const double y = zero[1] - k * step * scale;
        drawing.line(side, y, side - 5 * unit, y, palette.muted);
        drawing.text(side - 9 * unit, y + 4 * unit, label(k), size, palette.muted, TextSide::right);
    }
    drawing.text(side - 9 * unit, base + 19 * unit, name, size, palette.muted, TextSide::right);
}

void draw_axes(Drawing& drawing, const Projection& to, std::pair<double, double> place, const Palette& palette) {
    constexpr double length = 32, beyond = 1.35, size = 13;  // [pixels]
    const Point zero = to({0, 0, 0});
    const double scale = length / to.pixels_per_metre();
    for (std::size_t k = 0; k < 3; ++k) {
        Point unit{};
        unit[k] = scale;
        const Point end = to(unit);
        const double dx = end[0] - zero[0], dy = end[1] - zero[1];
        drawing.line(place.first, place.second, place.first + dx, place.second + dy, palette.muted, 1.5);
        drawing.text(place.first + beyond * dx, place.second + beyond * dy + 0.35 * size, std::string(1, "xyz"[k]),
                     size, palette.ink, TextSide::middle);
    }
}

void draw_scale_bar(Drawing& drawing, const Projection& to, const PictureBox& box, const Palette& palette) {
    constexpr double least = 90, tick = 5, size = 13;  // [pixels]
    const double scale = to.pixels_per_metre(), length = even_step(least / scale);
    const auto [name, factor] = shown_unit("m", length);
    const double left = box.left, right = left + scale * length, y = box.bottom;
    drawing.line(left, y, right, y, palette.ink, 2);
    for (const double x : {left, right}) drawing.line(x, y - tick, x, y + tick, palette.ink, 2);
    drawing.text(0.5 * (left + right), y - 2 * tick, fmt::format("{:g} {}", factor * length, name), size, palette.ink,
                 TextSide::middle);
}

}  // namespace sluice
