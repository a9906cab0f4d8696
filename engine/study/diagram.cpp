#include "engine/study/diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/study/diagram_marks.hpp"
#include "engine/study/fit.hpp"
#include "engine/study/label_layout.hpp"
#include "engine/study/log_axis.hpp"
#include "engine/study/words.hpp"

namespace sluice {
namespace {

// Measures of the page [px].
constexpr double page_width = 940, left_margin = 78, right_margin = 300, top_margin = 70;
constexpr double least_height = 380, axis_room = 52, footer_line = 17, block_gap = 8;
constexpr double name_size = 12.5, note_size = 11, spacing_size = 10.5, name_line = 16, note_line = 15;
constexpr std::size_t name_letters = 38;  ///< that fit into the right margin
constexpr double mark_size = 10;          ///< marks nearer than this share their words
constexpr std::size_t crowd = 30;         ///< points that all find room for their spacing
constexpr double padding = 1.3;           ///< of the ranges, as a factor
/// How far the axis of errors is stretched to show the truth's uncertainty, as a factor.
constexpr double stretch = 8;

/// One line of the diagram.
struct Line {
    std::size_t method = 0;
    std::vector<const StudyPoint*> points;  ///< coarse to fine
    std::vector<Place> places;
};

/// "modern, mixed, courant 0.5" in lines that fit beside the diagram.
std::vector<std::string> wrapped(const std::string& name) {
    std::vector<std::string> lines(1);
    for (std::size_t start = 0; start < name.size();) {
        const std::size_t comma = name.find(", ", start);
        const std::size_t end = comma == std::string::npos ? name.size() : comma + 2;
        const std::string word = name.substr(start, end - start);
        if (!lines.back().empty() && lines.back().size() + word.size() > name_letters) lines.emplace_back();
        lines.back() += word;
        start = end;
    }
    return lines;
}

class Diagram {
  public:
    Diagram(const Study& study, std::size_t quantity)
        : study_(study),
          quantity_(study.quantities[quantity]),
          index_(quantity),
          lines_(lines_of(study, quantity)),
          plot_(plot_box()),
          svg_(page_width, plot_.bottom + axis_room + footer_line * static_cast<double>(footer().size()) + 8),
          x_(cost_axis()),
          y_(error_axis()),
          labels_({plot_.left, plot_.top, plot_.right + 14, plot_.bottom}) {}

    Svg draw() {
        draw_heading();
        if (lines_.empty()) {
            svg_.text({plot_.left, plot_.top + 30}, "No run of this study has this error.", "fill=\"#555555\"");
            return svg_;
        }
        for (Line& line : lines_)
            for (const StudyPoint* p : line.points) line.places.push_back(place_of(p));
        draw_grid();
        collect_obstacles();
        draw_band();
        draw_front();
        draw_names();
        for (const Line& line : lines_) draw_line(line);
        for (const Line& line : lines_) draw_points(line);
        draw_spacings();
        draw_footer();
        return svg_;
    }

  private:
    /// Errors of 0 have no place on a logarithmic axis.
    static std::vector<Line> lines_of(const Study& study, std::size_t quantity) {
        std::vector<Line> lines;
        for (std::size_t m = 0; m < study.methods.size(); ++m) {
            Line line{m, {}, {}};
            for (const StudyPoint* p : points_of(study, m, quantity))
                if (*p->error[quantity] > 0 && p->cpu_seconds() > 0) line.points.push_back(p);
            if (!line.points.empty()) lines.push_back(std::move(line));
        }
        return lines;
    }

    double block_height(const Line& line) const {
        return name_line * static_cast<double>(wrapped(study_.methods[line.method]).size()) + note_line + block_gap;
    }

    SvgBox plot_box() const {
        double height = 0;
        for (const Line& line : lines_) height += block_height(line);
        return {left_margin, top_margin, page_width - right_margin, top_margin + std::max(height, least_height)};
    }

    double error_of(const StudyPoint* p) const { return *p->error[index_]; }
    Place place_of(const StudyPoint* p) const { return {x_(p->cpu_seconds()), y_(error_of(p))}; }

    template <class Value>
    std::pair<double, double> range(Value value) const {
        double low = std::numeric_limits<double>::infinity(), high = 0;
        for (const Line& line : lines_)
            for (const StudyPoint* p : line.points) {
                low = std::min(low, value(p));
                high = std::max(high, value(p));
            }
        return high > 0 ? std::pair(low, high) : std::pair(1.0, 10.0);
    }

    LogAxis cost_axis() const {
        const auto [low, high] = range([](const StudyPoint* p) { return p->cpu_seconds(); });
        return {low / padding, high * padding, plot_.left, plot_.right};
    }

    LogAxis error_axis() const {
        auto [low, high] = range([this](const StudyPoint* p) { return error_of(p); });
        if (const auto band = quantity_.uncertainty; band && *band > low / stretch && *band < high * stretch) {
            low = std::min(low, *band / padding);  // leaves room for the words below the band's edge
            high = std::max(high, *band);
        }
        return {low / padding, high * padding, plot_.bottom, plot_.top};
    }

    void draw_heading() {
        svg_.text({left_margin, 26}, fmt::format("{}: error of {} against CPU time", study_.title, quantity_.name),
                  "font-size=\"17\" font-weight=\"bold\" fill=\"#111111\"");
        svg_.text({left_margin, 46},
                  fmt::format("{}; 100 % = {:.4g} {}", quantity_.meaning, quantity_.scale, quantity_.unit),
                  "fill=\"#444444\"");
    }

    void draw_grid() {
        const auto stroke = [](double value, const std::vector<double>& strong) {
            const bool is_strong = std::find(strong.begin(), strong.end(), value) != strong.end();
            return is_strong ? "stroke=\"#dddddd\"" : "stroke=\"#f0f0f0\"";
        };
        for (const double v : x_.fine()) svg_.line({x_(v), plot_.top}, {x_(v), plot_.bottom}, stroke(v, x_.labelled()));
        for (const double v : y_.fine()) svg_.line({plot_.left, y_(v)}, {plot_.right, y_(v)}, stroke(v, y_.labelled()));
        for (const double v : x_.labelled())
            svg_.text({x_(v), plot_.bottom + 17}, fmt::format("{:g}", v), "text-anchor=\"middle\" fill=\"#333333\"");
        for (const double v : y_.labelled())
            svg_.text({plot_.left - 7, y_(v) + 4}, fmt::format("{:g} %", 100 * v),
                      "text-anchor=\"end\" fill=\"#333333\"");
        svg_.polyline({{plot_.left, plot_.top}, {plot_.left, plot_.bottom}, {plot_.right, plot_.bottom}},
                      "fill=\"none\" stroke=\"#555555\"");
        const std::string of_repeats = study_.repeats > 1 ? fmt::format(", median of {}", study_.repeats) : "";
        svg_.text(
            {0.5 * (plot_.left + plot_.right), plot_.bottom + 38},
            fmt::format("CPU time of a run [s], {}{}",
                        study_.threads == 1 ? "one thread" : fmt::format("{} threads", study_.threads), of_repeats),
            "text-anchor=\"middle\" fill=\"#111111\"");
        svg_.text({plot_.left, plot_.top - 8}, "error", "text-anchor=\"end\" fill=\"#111111\"");
    }

    void collect_obstacles() {
        for (const Line& line : lines_) {
            for (std::size_t i = 0; i < line.points.size(); ++i) {
                const Place p = line.places[i];
                const auto [least, most] = std::minmax_element(line.points[i]->cpu.begin(), line.points[i]->cpu.end());
                labels_.add_obstacle({p.x - 6, p.y - 6, p.x + 6, p.y + 6});
                labels_.add_stroke({{x_(*least), p.y}, {x_(*most), p.y}});
            }
            labels_.add_stroke(line.places);
        }
    }

    void draw_band() {
        if (!quantity_.uncertainty || !(*quantity_.uncertainty > y_.low())) return;
        const double top = y_(std::min(*quantity_.uncertainty, y_.high()));
        svg_.rectangle({plot_.left, top, plot_.right, plot_.bottom}, "fill=\"#7f7f7f\" fill-opacity=\"0.13\"");
        svg_.line({plot_.left, top}, {plot_.right, top}, "stroke=\"#777777\" stroke-dasharray=\"2 3\"");
        const std::string words = fmt::format("below {} more accuracy buys nothing: the {} own uncertainty",
                                              percent_text(*quantity_.uncertainty),
                                              quantity_.extrapolated ? "extrapolation's" : "reference's");
        const double width = text_width(words, note_size), height = note_size + 4;
        std::vector<SvgBox> candidates;
        for (const double y : {top + 4, plot_.bottom - height - 4, top + 22, top - height - 3})
            for (const double x : {plot_.left + 8, plot_.right - width - 8, 0.5 * (plot_.left + plot_.right - width)})
                candidates.push_back({x, y, x + width, y + height});
        if (const auto box = labels_.place(candidates))
            svg_.text({box->left, box->bottom - 4}, words, "font-size=\"11\" fill=\"#555555\"");
    }

    std::vector<const StudyPoint*> front() const {
        std::vector<const StudyPoint*> all, best;
        std::vector<CostAndError> costs;
        for (const Line& line : lines_)
            for (const StudyPoint* p : line.points) {
                all.push_back(p);
                costs.push_back({p->cpu_seconds(), error_of(p)});
            }
        for (const std::size_t i : pareto_front(costs)) best.push_back(all[i]);
        return best;
    }

    void draw_front() {
        std::vector<Place> steps;
        for (const StudyPoint* p : front()) {
            const Place at = place_of(p);
            if (!steps.empty()) steps.push_back({at.x, steps.back().y});
            steps.push_back(at);
        }
        if (steps.size() < 2) return;
        svg_.polyline(steps,
                      "class=\"front\" fill=\"none\" stroke=\"#cfcfcf\" stroke-width=\"6\" "
                      "stroke-linejoin=\"round\" stroke-linecap=\"round\"");
        const double width = text_width("Pareto front", note_size), height = note_size + 3;
        std::vector<SvgBox> candidates;
        for (std::size_t i = 1; i < steps.size(); i += 2)
            for (const double x : {steps[i - 1].x + 8, steps[i].x - width - 8})
                candidates.push_back({x, steps[i].y + 6, x + width, steps[i].y + 6 + height});
        labels_.add_stroke(steps);
        if (const auto box = labels_.place(candidates))
            svg_.text({box->left, box->bottom - 3}, "Pareto front",
                      "font-size=\"11\" font-style=\"italic\" fill=\"#777777\"");
    }

    /// Right of the diagram, each joined with the last point of its line.
    void draw_names() {
        std::vector<double> wanted, heights;
        for (const Line& line : lines_) {
            wanted.push_back(line.places.back().y);
            heights.push_back(block_height(line));
        }
        const std::vector<double> middles = spread(wanted, heights, plot_.top, plot_.bottom);
        for (std::size_t i = 0; i < lines_.size(); ++i) draw_name(lines_[i], middles[i], heights[i]);
    }

    void draw_name(const Line& line, double middle, double height) {
        const LineStyle style = line_style(line.method);
        const double x = plot_.right + 22, text_x = x + 13;
        double y = middle - (height - block_gap) / 2 + name_size;
        const Place mark{x, y - 4};
        svg_.line(line.places.back(), {x - 8, mark.y},
                  fmt::format("stroke=\"{}\" stroke-width=\"0.8\" stroke-opacity=\"0.55\" stroke-dasharray=\"1 3\"",
                              style.colour));
        svg_.raw(mark_element(style, mark, fmt::format("fill=\"{0}\" stroke=\"{0}\"", style.colour), ""));
        for (const std::string& part : wrapped(study_.methods[line.method])) {
            svg_.text({text_x, y}, part,
                      fmt::format("font-size=\"{}\" font-weight=\"bold\" fill=\"#222222\"", name_size));
            y += name_line;
        }
        svg_.raw(slopes_element({text_x, y - 1}, slopes_of(line.points, index_), note_size));
    }

    void draw_line(const Line& line) {
        const LineStyle style = line_style(line.method);
        svg_.polyline(line.places, fmt::format("class=\"method\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{}",
                                               style.colour, style.dash));
    }

    void draw_points(const Line& line) {
        const LineStyle style = line_style(line.method);
        const std::vector<const StudyPoint*> best = front();
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const StudyPoint* p = line.points[i];
            const auto [least, most] = std::minmax_element(p->cpu.begin(), p->cpu.end());
            if (*most > *least)
                svg_.line({x_(*least), line.places[i].y}, {x_(*most), line.places[i].y},
                          fmt::format("stroke=\"{}\" stroke-width=\"3\" stroke-opacity=\"0.4\"", style.colour));
            const bool on_front = std::find(best.begin(), best.end(), p) != best.end();
            const std::string title =
                fmt::format("{}, spacing {}: {} in {} CPU-s", study_.methods[line.method], length_text(p->spacing),
                            percent_text(error_of(p)), seconds_text(p->cpu_seconds()));
            svg_.raw(mark_element(style, line.places[i],
                                  fmt::format("class=\"point\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"",
                                              on_front ? style.colour : "#ffffff", style.colour),
                                  title));
        }
    }

    /// The front's points first; in a crowd the others only where there is room right beside them.
    void draw_spacings() {
        const std::vector<const StudyPoint*> best = front();
        std::size_t count = 0;
        for (const Line& line : lines_) count += line.points.size();
        for (const bool of_front : {true, false})
            for (const Line& line : lines_)
                for (std::size_t i = 0; i < line.points.size(); ++i) {
                    const bool on_front = std::find(best.begin(), best.end(), line.points[i]) != best.end();
                    if (on_front == of_front)
                        draw_spacing(line.places[i], length_text(line.points[i]->spacing),
                                     on_front || count <= crowd ? LabelLayout::farthest : LabelLayout::beside);
                }
    }

    /// Where there is no room the point's title has it.
    void draw_spacing(Place p, const std::string& words, double reach) {
        const auto says_it = [&](const auto& told) {
            return told.second == words && std::hypot(told.first.x - p.x, told.first.y - p.y) < mark_size;
        };
        if (std::any_of(told_.begin(), told_.end(), says_it)) return;
        const auto box = labels_.place_beside(p, text_width(words, spacing_size), spacing_size, reach);
        if (!box) return;
        told_.emplace_back(p, words);
        const Place edge{std::clamp(p.x, box->left, box->right), std::clamp(p.y, box->top, box->bottom)};
        if (std::hypot(edge.x - p.x, edge.y - p.y) > LabelLayout::beside + 1)
            svg_.line(p, edge, "stroke=\"#999999\" stroke-width=\"0.6\"");
        svg_.text({0.5 * (box->left + box->right), box->bottom - 1.5}, words,
                  fmt::format("class=\"spacing\" stroke=\"#ffffff\" stroke-width=\"2.5\" stroke-opacity=\"0.75\" "
                              "paint-order=\"stroke\" text-anchor=\"middle\" font-size=\"{}\" fill=\"#333333\"",
                              spacing_size));
    }

    std::vector<std::string> footer() const {
        std::vector<std::string> lines{
            "Marks: runs with their spacing; filled = on the Pareto front: no other run is both "
            "cheaper and more accurate."};
        if (!quantity_.note.empty()) lines.push_back("Truth: " + quantity_.note);
        std::size_t failed = 0;
        for (const StudyPoint& p : study_.points) failed += p.state == PointState::failed;
        if (failed > 0)
            lines.push_back(fmt::format("{} of {} settings failed; the table has them.", failed, study_.points.size()));
        return lines;
    }

    void draw_footer() {
        double y = plot_.bottom + axis_room + 10;
        for (const std::string& line : footer()) {
            svg_.text({left_margin, y}, line, "font-size=\"11\" fill=\"#555555\"");
            y += footer_line;
        }
    }

    const Study& study_;
    const Quantity& quantity_;
    std::size_t index_;
    std::vector<Line> lines_;
    SvgBox plot_;
    Svg svg_;
    LogAxis x_, y_;
    LabelLayout labels_;
    std::vector<std::pair<Place, std::string>> told_;  ///< spacings that have their words
};

}  // namespace

Svg diagram(const Study& study, std::size_t quantity) { return Diagram(study, quantity).draw(); }

}  // namespace sluice
