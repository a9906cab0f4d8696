#include "engine/study/label_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace sluice {
namespace {

constexpr double stroke_step = 3;  ///< [px]
/// Middles of words around a point, best first: right above, below, and so on round.
constexpr std::array<Place, 8> directions{
    {{0.7, -0.7}, {-0.7, -0.7}, {0.7, 0.7}, {-0.7, 0.7}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}}};
constexpr std::array<double, 4> distances{7, LabelLayout::beside, 18, LabelLayout::farthest};
constexpr double gap = 6;  ///< words closer than this read as one [px]

SvgBox around(Place middle, double width, double height) {
    return {middle.x - width / 2, middle.y - height / 2, middle.x + width / 2, middle.y + height / 2};
}

}  // namespace

void LabelLayout::add_stroke(const std::vector<Place>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Place a = points[i - 1], b = points[i];
        const int steps = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / stroke_step);
        for (int k = 0; k <= steps; ++k)
            strokes_.push_back({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps});
    }
}

std::size_t LabelLayout::strokes_under(const SvgBox& box) const {
    return static_cast<std::size_t>(std::count_if(strokes_.begin(), strokes_.end(), [&](const Place& p) {
        return p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom;
    }));
}

std::optional<SvgBox> LabelLayout::place(const std::vector<SvgBox>& candidates) {
    std::optional<SvgBox> best;
    std::size_t covered = std::numeric_limits<std::size_t>::max();
    for (const SvgBox& box : candidates) {
        if (!box.lies_in(limits_)) continue;
        if (std::any_of(obstacles_.begin(), obstacles_.end(), [&](const SvgBox& o) { return o.meets(box); })) continue;
        const std::size_t under = strokes_under(box);
        if (under >= covered) continue;
        best = box;
        covered = under;
    }
    if (best) add_obstacle(*best);
    return best;
}

std::optional<SvgBox> LabelLayout::place_beside(Place point, double width, double height, double reach) {
    std::vector<SvgBox> candidates;
    width += gap;
    for (const double distance : distances) {
        if (distance > reach) break;
        for (const Place& d : directions)
            candidates.push_back(around({point.x + d.x * distance +
                                             (d.x > 0   ? 0.5
                                              : d.x < 0 ? -0.5
                                                        : 0) *
                                                 width,
                                         point.y + d.y * distance +
                                             (d.y > 0   ? 0.5
                                              : d.y < 0 ? -0.5
                                                        : 0) *
                                                 height},
                                        width, height));
    }
    return place(candidates);
}

std::vector<double> spread(const std::vector<double>& wanted, const std::vector<double>& heights, double low,
                           double high) {
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
    std::vector<double> middle = wanted;
    double edge = low;
    for (const std::size_t i : order) {
        middle[i] = std::max(wanted[i], edge + heights[i] / 2);
        edge = middle[i] + heights[i] / 2;
    }
    edge = high;
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        middle[*i] = std::min(middle[*i], edge - heights[*i] / 2);
        edge = middle[*i] - heights[*i] / 2;
    }
    return middle;
}

}  // namespace sluice
