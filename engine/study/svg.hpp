// A small writer of SVG: elements with attributes, text escaped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sluice {

/// & < > " as XML wants them.
std::string xml_text(std::string_view text);

struct Place {
    double x = 0, y = 0;
};

struct SvgBox {
    double left = 0, top = 0, right = 0, bottom = 0;

    bool meets(const SvgBox& o) const { return left < o.right && o.left < right && top < o.bottom && o.top < bottom; }
    bool lies_in(const SvgBox& o) const {
        return left >= o.left && right <= o.right && top >= o.top && bottom <= o.bottom;
    }
};

class Svg {
  public:
    /// In pixels.
    Svg(double width, double height);

    /// `attributes` as in XML, e.g. `fill="none" stroke="#000"`.
    void line(Place a, Place b, std::string_view attributes);
    void polyline(const std::vector<Place>& points, std::string_view attributes);
    void rectangle(const SvgBox& box, std::string_view attributes);
    void text(Place at, std::string_view words, std::string_view attributes);
    /// Any element, written by the caller.
    void raw(std::string_view element);

    /// Groups nest.
    void open_group(std::string_view attributes);
    void close_group();

    /// All that was drawn, to be put into another drawing.
    const std::string& content() const { return content_; }
    double width() const { return width_; }
    double height() const { return height_; }
    /// The whole document.
    std::string document() const;

  private:
    double width_, height_;
    std::string content_;
};

/// About as wide as Helvetica or its like draws it [px]; on the safe side.
double text_width(std::string_view words, double size);

}  // namespace sluice
