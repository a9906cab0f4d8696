#include "engine/study/words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace sluice {
namespace {

/// Two digits that count, never as a power of ten.
std::string two_digits(double value) {
    if (!(value > 0)) return "0";
    const int decimals = 1 - static_cast<int>(std::floor(std::log10(value) + 1e-9));  // 9.999 is 10 already
    return fmt::format("{:.{}f}", value, decimals > 0 ? decimals : 0);
}

}  // namespace

std::string percent_text(double share) {
    if (share > 0 && share < 1e-6) return fmt::format("{:.0e} %", 100 * share);  // more zeros than anyone counts
    return two_digits(100 * share) + " %";
}

std::string length_text(double metres) {
    if (metres >= 1) return fmt::format("{:.3g} m", metres);
    if (metres >= 1e-4) return fmt::format("{:.3g} mm", 1e3 * metres);
    return fmt::format("{:.3g} µm", 1e6 * metres);
}

std::string seconds_text(double seconds) { return two_digits(seconds); }

std::string ratio_text(double ratio) { return two_digits(ratio); }

}  // namespace sluice
