// Colours of values: perceptually even maps, and a diverging one for what has two signs.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sluice {

struct ColorMap {
    const char* name;
    std::array<std::uint32_t, 17> color;  ///< 0xRRGGBB at equal steps
};

/// viridis, cividis and plasma (van der Walt, Smith, Firing; Nuñez, Anderton, Renslow 2018), and coolwarm (Moreland
/// 2009), each at every sixteenth, between which colours are mixed.
std::span<const ColorMap> color_maps();

/// Throws RunReadError for an unknown name, with the nearest one.
const ColorMap& color_map(const std::string& name);

/// Whether a range reaches so far to both sides of zero that its middle should be at zero.
bool is_signed_range(double low, double high);

/// 0xRRGGBB; `part` is cut to 0 … 1.
std::uint32_t color_at(const ColorMap& map, double part);

}  // namespace sluice
