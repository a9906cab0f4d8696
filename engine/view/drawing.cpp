#include "engine/view/drawing.hpp"

#include <cairo.h>

#include <numbers>

#include "engine/base/errors.hpp"

namespace sluice {
namespace {

double channel(std::uint32_t color, unsigned shift) { return (color >> shift & 0xFFU) / 255.0; }

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Drawing::Drawing(int width, int height, std::uint32_t background)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)), cairo_(cairo_create(surface_)) {
    if (cairo_status(cairo_) != CAIRO_STATUS_SUCCESS) throw OutputError("cairo: cannot make a picture of this size");
    cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    use(background);
    cairo_paint(cairo_);
}

Drawing::~Drawing() {
    cairo_destroy(cairo_);
    cairo_surface_destroy(surface_);
}

void Drawing::use(std::uint32_t color) {
    cairo_set_source_rgb(cairo_, channel(color, 16), channel(color, 8), channel(color, 0));
}

void Drawing::clip(const PictureBox& box) {
    cairo_rectangle(cairo_, box.left, box.top, box.right - box.left, box.bottom - box.top);
    cairo_clip(cairo_);
}

void Drawing::unclip() { cairo_reset_clip(cairo_); }

void Drawing::line(double x0, double y0, double x1, double y1, std::uint32_t color, double width) {
    use(color);
    cairo_set_line_width(cairo_, width);
    cairo_move_to(cairo_, x0, y0);
    cairo_line_to(cairo_, x1, y1);
    cairo_stroke(cairo_);
}

void Drawing::dashed_line(double x0, double y0, double x1, double y1, std::uint32_t color, double dash) {
    cairo_set_dash(cairo_, &dash, 1, 0);
    line(x0, y0, x1, y1, color);
    cairo_set_dash(cairo_, nullptr, 0, 0);
}

void Drawing::circle(double x, double y, double radius, std::uint32_t color, double width) {
    use(color);
    cairo_set_line_width(cairo_, width);
    cairo_new_path(cairo_);
    cairo_arc(cairo_, x, y, radius, 0, 2 * std::numbers::pi);
    cairo_stroke(cairo_);
}

void Drawing::fill(const PictureBox& box, std::uint32_t color) {
    use(color);
    cairo_rectangle(cairo_, box.left, box.top, box.right - box.left, box.bottom - box.top);
    cairo_fill(cairo_);
}

void Drawing::text(double x, double y, std::string_view words, double size, std::uint32_t color, TextSide side) {
    const std::string text(words);
    cairo_set_font_size(cairo_, size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, text.c_str(), &extents);
    const double back = part_before(side);
    use(color);
    cairo_move_to(cairo_, x - back * extents.x_advance, y);
    cairo_show_text(cairo_, text.c_str());
}

void Drawing::label(double x, double y, std::string_view words, double size, std::uint32_t color, std::uint32_t halo,
                    TextSide side) {
    const std::string text(words);
    cairo_set_font_size(cairo_, size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, text.c_str(), &extents);
    const double back = part_before(side);
    use(halo);
    cairo_move_to(cairo_, x - back * extents.x_advance, y);
    cairo_text_path(cairo_, text.c_str());
    cairo_set_line_width(cairo_, size / 4);
    cairo_stroke(cairo_);
    this->text(x, y, words, size, color, side);
}

void Drawing::gradient(const PictureBox& box, const ColorMap& map) {
    cairo_pattern_t* pattern = cairo_pattern_create_linear(box.left, 0, box.right, 0);
    for (std::size_t k = 0; k < map.color.size(); ++k)
        cairo_pattern_add_color_stop_rgb(pattern, static_cast<double>(k) / static_cast<double>(map.color.size() - 1),
                                         channel(map.color[k], 16), channel(map.color[k], 8), channel(map.color[k], 0));
    cairo_set_source(cairo_, pattern);
    cairo_rectangle(cairo_, box.left, box.top, box.right - box.left, box.bottom - box.top);
    cairo_fill(cairo_);
    cairo_pattern_destroy(pattern);
}

unsigned char* Drawing::pixels() {
    cairo_surface_flush(surface_);
    return cairo_image_surface_get_data(surface_);
}

int Drawing::stride() const { return cairo_image_surface_get_stride(surface_); }
void Drawing::pixels_changed() { cairo_surface_mark_dirty(surface_); }

std::string Drawing::png() const {
    std::string bytes;
    if (cairo_surface_write_to_png_stream(surface_, append, &bytes) != CAIRO_STATUS_SUCCESS)
        throw OutputError("cairo: cannot make a PNG");
    return bytes;
}

}  // namespace sluice
