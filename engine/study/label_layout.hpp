// Where words go in a diagram so that none hides another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/study/svg.hpp"

namespace sluice {

class LabelLayout {
  public:
    /// Words stay inside `limits`.
    explicit LabelLayout(const SvgBox& limits) : limits_(limits) {}

    /// What no word may cover.
    void add_obstacle(const SvgBox& box) { obstacles_.push_back(box); }
    /// What words rather do not cover: a stroke.
    void add_stroke(const std::vector<Place>& points);

    /// The first of the boxes that covers no obstacle, or of several the one that covers the least of the strokes; it
    /// becomes an obstacle. None if all cover one.
    std::optional<SvgBox> place(const std::vector<SvgBox>& candidates);

    /// A box for a word beside a point, the nearer the better; no farther than `reach`.
    std::optional<SvgBox> place_beside(Place point, double width, double height, double reach = farthest);

    static constexpr double farthest = 28, beside = 11;  ///< of a word's edge from its point [px]

  private:
    std::size_t strokes_under(const SvgBox& box) const;

    SvgBox limits_;
    std::vector<SvgBox> obstacles_;
    std::vector<Place> strokes_;  ///< points a few pixels apart
};

/// Moves blocks of these heights, wanted at these middles, apart along one axis: in the order of their wishes, none
/// over another, all within [low, high] if there is room. Returns their middles.
std::vector<double> spread(const std::vector<double>& wanted, const std::vector<double>& heights, double low,
                           double high);

}  // namespace sluice
