// What is what in the picture of a scene.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/geometry/packing.hpp"
#include "engine/view/scene_marks.hpp"

namespace sluice {

/// Particles of one body or wall, and its lines in the legend.
struct DrawnSet {
    std::string name, note;
    const Packing* packing = nullptr;
    const Shape* clamp = nullptr;  ///< may be null
    double spacing = 0;            ///< [m]
    std::uint32_t color = 0;
};

/// Of clamped particles.
constexpr std::uint32_t darkened(std::uint32_t color) { return (color >> 1U) & 0x7F7F7FU; }

/// "8,960"
std::string count_text(std::size_t count);

/// Downwards from a place in the picture.
void draw_legend(Drawing& drawing, const MarkPlace& at, const std::vector<DrawnSet>& sets,
                 std::pair<double, double> corner);

}  // namespace sluice
