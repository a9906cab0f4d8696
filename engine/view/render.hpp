// A run as pictures, one per frame.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/view/frame_picture.hpp"

namespace sluice {

/// What a medium is coloured by; what is not said is chosen.
struct ColorOptions {
    std::string field;  ///< "none" = one colour
    std::string map;
    std::optional<std::pair<double, double>> range;  ///< in SI units
};

struct RenderOptions {
    std::filesystem::path directory;  ///< of the run
    std::filesystem::path output;     ///< folder for the pictures
    ColorOptions fluid, solid;
    std::size_t every = 1;  ///< of so many frames one is drawn
    PictureStyle style;     ///< but for its colours
};

struct RenderResult {
    std::size_t frames = 0;
    std::vector<std::string> left_out;  ///< frames that could not be read, and why
};

/// Writes frame_0000.png, frame_0001.png …; pictures of an earlier call are removed. Throws RunReadError, OutputError.
RenderResult render_run(const RenderOptions& options);

}  // namespace sluice
