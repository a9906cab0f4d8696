#include "engine/view/color_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/errors.hpp"
#include "engine/scene/table/suggestion.hpp"

namespace sluice {
namespace {

constexpr std::array<ColorMap, 4> maps{
    {{"viridis",
      {0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d, 0x2c728e, 0x26828e, 0x21918c, 0x1fa088, 0x28ae80,
       0x3fbc73, 0x5ec962, 0x84d44b, 0xaddc30, 0xd8e219, 0xfde725}},
     {"cividis",
      {0x00224e, 0x002e6a, 0x1a386f, 0x32436d, 0x434e6c, 0x535a6d, 0x61656f, 0x6f7073, 0x7d7c78, 0x8c8878, 0x9b9476,
       0xaba072, 0xbcae6c, 0xcdbb63, 0xdec958, 0xf0d846, 0xfee838}},
     {"plasma",
      {0x0d0887, 0x310597, 0x4c02a1, 0x6600a7, 0x7e03a8, 0x9511a1, 0xaa2395, 0xbc3587, 0xcc4778, 0xda5a6a, 0xe66c5c,
       0xf0804e, 0xf89540, 0xfdac33, 0xfdc527, 0xf8df25, 0xf0f921}},
     {"coolwarm",
      {0x3b4cc0, 0x4e68d8, 0x6282ea, 0x779af7, 0x8db0fe, 0xa3c2fe, 0xb9d0f9, 0xccd9ed, 0xdddcdc, 0xecd3c5, 0xf5c4ac,
       0xf7b093, 0xf4987a, 0xeb7d62, 0xdd5f4b, 0xca3b37, 0xb40426}}}};

}  // namespace

std::span<const ColorMap> color_maps() { return maps; }

const ColorMap& color_map(const std::string& name) {
    std::vector<std::string> names;
    for (const ColorMap& map : maps) {
        if (name == map.name) return map;
        names.emplace_back(map.name);
    }
    throw RunReadError(
        fmt::format("colour map: found \"{}\", expected {}{}", name, one_of(names), did_you_mean(name, names)));
}

bool is_signed_range(double low, double high) {
    // A water's pressure that dips below zero here and there is no quantity of two signs; a fifth is.
    return low < 0 && high > 0 && std::min(-low, high) > 0.2 * std::max(-low, high);
}

std::uint32_t color_at(const ColorMap& map, double part) {
    const double last = static_cast<double>(map.color.size() - 1);
    const double place = std::clamp(part, 0.0, 1.0) * last;
    const auto k = static_cast<std::size_t>(std::min(std::floor(place), last - 1));
    const double w = place - static_cast<double>(k);
    std::uint32_t mixed = 0;
    for (const unsigned shift : {16U, 8U, 0U}) {
        const double a = map.color[k] >> shift & 0xFFU, b = map.color[k + 1] >> shift & 0xFFU;
        mixed |= static_cast<std::uint32_t>(std::lround(a + w * (b - a))) << shift;
    }
    return mixed;
}

}  // namespace sluice
