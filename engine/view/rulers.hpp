// Lengths along a picture, and numbers as pictures show them.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "engine/view/drawing.hpp"
#include "engine/view/palette.hpp"

namespace sluice {

/// The unit that keeps numbers short, and what a value in SI is multiplied by.
std::pair<std::string, double> shown_unit(std::string_view unit, double size);

/// A hyphen in front of a number as the sign that it stands for.
std::string with_minus(const std::string& number);

/// A step of 1, 2 or 5 times a power of ten, at least as large.
double even_step(double least);

/// Coordinates along the lower and the left side of a box in a picture, straight on. `unit`: pixels of a picture that
/// is 720 high.
void draw_rulers(Drawing& drawing, const Projection& to, const PictureBox& box, double unit, const Palette& palette);

/// The directions of x, y and z, about a place in the picture.
void draw_axes(Drawing& drawing, const Projection& to, std::pair<double, double> place, const Palette& palette);

/// A length in the lower left corner of a box.
void draw_scale_bar(Drawing& drawing, const Projection& to, const PictureBox& box, const Palette& palette);

}  // namespace sluice
