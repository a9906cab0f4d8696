#include "engine/view/scene_legend.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sluice {
namespace {

constexpr double text_size = 13, note_size = 12, line_height = 15, gap = 10, indent = 22;  // [pixels]
constexpr std::size_t line_letters = 36;

/// At ", ", so that lines are short enough.
std::vector<std::string> broken(const std::string& text) {
    std::vector<std::string> lines{""};
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t comma = text.find(", ", start);
        const std::size_t end = comma == std::string::npos ? text.size() : comma + 2;
        const std::string part = text.substr(start, end - start);
        if (!lines.back().empty() && lines.back().size() + part.size() > line_letters) lines.emplace_back();
        lines.back() += part;
        start = end;
    }
    return lines;
}

/// Entries, one below the other.
class Legend {
  public:
    Legend(Drawing& drawing, const Palette& palette, std::pair<double, double> corner)
        : drawing_(drawing), palette_(palette), left_(corner.first), y_(corner.second) {}

    /// `draw(x, y)`: the sign, about its middle.
    template <class Draw>
    void add(const std::string& name, const std::string& note, Draw draw) {
        draw(left_ + 6, y_ - 5);
        drawing_.text(left_ + indent, y_, name, text_size, palette_.ink);
        for (const std::string& line : broken(note)) {
            y_ += line_height;
            drawing_.text(left_ + indent, y_, line, note_size, palette_.muted);
        }
        y_ += line_height + gap;
    }
    void add(const std::string& name, const std::string& note, std::uint32_t color) {
        constexpr double half = 6;
        add(name, note, [&](double x, double y) { drawing_.fill({x - half, y - half, x + half, y + half}, color); });
    }

  private:
    Drawing& drawing_;
    Palette palette_;
    double left_, y_;
};

/// "x: 0 to 1 m"
std::string periodic_text(const Scene& scene) {
    std::string text;
    for (std::size_t k = 0; k < 3; ++k)
        if (scene.periodic[k])
            text += fmt::format("{}{}: {:.4g} to {:.4g} m", text.empty() ? "" : ", ", "xyz"[k],
                                scene.periodic[k]->first, scene.periodic[k]->second);
    return text;
}

/// The names that `chosen` takes, apart by commas.
template <class Things, class Chosen>
std::string names_of(const Things& things, Chosen chosen) {
    std::string names;
    for (const auto& thing : things)
        if (chosen(thing)) names += (names.empty() ? "" : ", ") + thing.name;
    return names;
}

void add_marks(Legend& legend, Drawing& drawing, const MarkPlace& at) {
    constexpr double half = 7;
    const Scene& scene = at.scene;
    const auto line = [&](double x, double y) { drawing.line(x - half, y, x + half, y, at.palette.muted, 2); };
    const auto dashes = [&](double x, double y) { drawing.dashed_line(x - half, y, x + half, y, at.palette.ink, 3); };
    const auto marker = [&](double x, double y) { draw_marker(drawing, {x, y, 0}, at.palette); };
    const auto nothing = [](double, double) {};
    const std::string mirrors = names_of(scene.walls, [](const Wall& w) { return w.kind == WallKind::mirror; });
    if (!mirrors.empty()) legend.add("mirror walls", mirrors, line);
    const std::string sides = periodic_text(scene);
    if (!sides.empty()) legend.add("periodic", sides, dashes);
    const std::string placed = names_of(scene.probes, [](const Probe& p) { return p.has_place(); });
    if (!placed.empty()) legend.add("probes", placed, marker);
    const std::string others = names_of(scene.probes, [](const Probe& p) { return !p.has_place(); });
    if (!others.empty()) legend.add("probes without a place", others, nothing);
}

}  // namespace

std::string count_text(std::size_t count) {
    const std::string digits = fmt::format("{}", count);
    std::string text;
    for (std::size_t k = 0; k < digits.size(); ++k) {
        if (k > 0 && (digits.size() - k) % 3 == 0) text += ',';
        text += digits[k];
    }
    return text;
}

void draw_legend(Drawing& drawing, const MarkPlace& at, const std::vector<DrawnSet>& sets,
                 std::pair<double, double> corner) {
    Legend legend(drawing, at.palette, corner);
    for (const DrawnSet& set : sets) {
        legend.add(set.name, set.note, set.color);
        if (!set.clamp) continue;
        const auto& places = set.packing->position;
        const auto held =
            std::count_if(places.begin(), places.end(), [&](const Point& p) { return set.clamp->contains(p); });
        legend.add(set.name + ", clamped", count_text(static_cast<std::size_t>(held)) + " of its particles",
                   darkened(set.color));
    }
    add_marks(legend, drawing, at);
}

}  // namespace sluice
