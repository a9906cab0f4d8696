// Lines and words in a picture of pixels, by cairo.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "engine/view/color_map.hpp"
#include "engine/view/projection.hpp"

struct _cairo;
struct _cairo_surface;

namespace sluice {

/// Which part of a text stands at its place.
enum class TextSide { left, middle, right };

/// The part of a text's width that lies to the left of its place.
constexpr double part_before(TextSide side) {
    switch (side) {
        case TextSide::left:
            return 0;
        case TextSide::middle:
            return 0.5;
        case TextSide::right:
            return 1;
    }
    return 0;
}

class Drawing {
  public:
    Drawing(int width, int height, std::uint32_t background);
    ~Drawing();
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    /// Nothing is drawn outside of a box until unclip().
    void clip(const PictureBox& box);
    void unclip();
    void line(double x0, double y0, double x1, double y1, std::uint32_t color, double width = 1);
    /// In stretches of so many pixels, with gaps as long.
    void dashed_line(double x0, double y0, double x1, double y1, std::uint32_t color, double dash);
    void circle(double x, double y, double radius, std::uint32_t color, double width = 1);
    void fill(const PictureBox& box, std::uint32_t color);
    /// `side`: where the text's `x` is. `size` in pixels.
    void text(double x, double y, std::string_view words, double size, std::uint32_t color,
              TextSide side = TextSide::left);
    /// Text on a halo, readable on anything.
    void label(double x, double y, std::string_view words, double size, std::uint32_t color, std::uint32_t halo,
               TextSide side);
    void gradient(const PictureBox& box, const ColorMap& map);

    /// Blue, green, red, alpha; rows of stride() bytes. Lines and words of before are in it.
    unsigned char* pixels();
    int stride() const;
    /// After pixels() were written to.
    void pixels_changed();
    std::string png() const;

  private:
    void use(std::uint32_t color);

    _cairo_surface* surface_;
    _cairo* cairo_;
};

}  // namespace sluice
