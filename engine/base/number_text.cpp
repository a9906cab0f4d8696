#include "engine/base/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sluice {

std::string clock_text(double seconds) {
    const auto s = static_cast<long long>(std::lround(std::max(seconds, 0.0)));
    if (s < 3600) return fmt::format("{}:{:02}", s / 60, s % 60);
    return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

std::string short_number(double value) {
    constexpr std::array<const char*, 4> prefix{"", " k", " M", " G"};
    std::size_t k = 0;
    while (value >= 999.5 && k + 1 < prefix.size()) {
        value /= 1000;
        ++k;
    }
    if (k == 0) return fmt::format("{:.0f}", value);
    return fmt::format("{:.{}f}{}", value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0, prefix[k]);
}

std::string memory_text(double bytes) {
    const std::string number = short_number(bytes);
    return number + (bytes >= 999.5 ? "B" : " B");
}

}  // namespace sluice
