#include "engine/study/svg.hpp"

#include <fmt/format.h>

namespace sluice {
namespace {

constexpr const char* font = "Helvetica, Arial, 'Liberation Sans', sans-serif";
/// Mean width of a letter over the font's size: Helvetica's digits have 0.556, its mean over English text is 0.5.
constexpr double letter_width = 0.56;

}  // namespace

std::string xml_text(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                // Control characters are not allowed in XML at all.
                safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return safe;
}

double text_width(std::string_view words, double size) {
    std::size_t letters = 0;
    for (const char c : words) letters += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // UTF-8: first bytes only
    return letter_width * size * static_cast<double>(letters);
}

Svg::Svg(double width, double height) : width_(width), height_(height) {}

void Svg::line(Place a, Place b, std::string_view attributes) {
    raw(fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>", a.x, a.y, b.x, b.y,
                    attributes));
}

void Svg::polyline(const std::vector<Place>& points, std::string_view attributes) {
    std::string list;
    for (const Place& p : points) list += fmt::format("{}{:.1f},{:.1f}", list.empty() ? "" : " ", p.x, p.y);
    raw(fmt::format("<polyline points=\"{}\" {}/>", list, attributes));
}

void Svg::rectangle(const SvgBox& box, std::string_view attributes) {
    raw(fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>", box.left, box.top,
                    box.right - box.left, box.bottom - box.top, attributes));
}

void Svg::text(Place at, std::string_view words, std::string_view attributes) {
    raw(fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>", at.x, at.y, attributes, xml_text(words)));
}

void Svg::raw(std::string_view element) {
    content_ += element;
    content_ += '\n';
}

void Svg::open_group(std::string_view attributes) { raw(fmt::format("<g {}>", attributes)); }
void Svg::close_group() { raw("</g>"); }

std::string Svg::document() const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
        "{1:.0f}\" "
        "font-family=\"{2}\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{3}</svg>\n",
        width_, height_, font, content_);
}

}  // namespace sluice
