// One frame as a picture: particles, their colours' meaning, the time.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "engine/view/field_ranges.hpp"
#include "engine/view/palette.hpp"
#include "engine/view/projection.hpp"
#include "engine/view/run_folder.hpp"

namespace sluice {

/// What the colours of a medium show; without a field it has one colour.
struct MediumColors {
    std::string field;
    std::string map;
    double low = 0, high = 1;
};

struct PictureStyle {
    int width = 1280, height = 720;  ///< [pixels]
    Theme theme = Theme::light;
    std::array<MediumColors, 3> colors;                              ///< by FrameMedium
    std::optional<std::array<std::pair<double, double>, 2>> window;  ///< part of x and y that is shown, in 2D [m]
    ViewAngles angles;                                               ///< in 3D
};

/// Range and map that suit a field in a medium. Throws RunReadError for a field without values there.
MediumColors suited_colors(const FieldRanges& ranges, const std::string& field, FrameMedium medium);

/// As PNG. `bounds`: of the run.
std::string frame_picture(const StoredFrame& frame, const RunFolder& run, const Projection::Bounds& bounds,
                          const PictureStyle& style);

}  // namespace sluice
