// Numbers of a study as people read them.
#pragma once

#include <string>

namespace sluice {

/// 0.043 → "4.3 %", 0.25 → "25 %", 0.00031 → "0.031 %"
std::string percent_text(double share);
/// 0.0008333 → "0.833 mm", 0.02 → "20 mm", 3e-5 → "30 µm", 1.5 → "1.5 m"
std::string length_text(double metres);
/// 0.21 → "0.21", 9.04 → "9.0", 31.2 → "31", 12345 → "12345"
std::string seconds_text(double seconds);
/// 3.9 → "3.9", 14.2 → "14"
std::string ratio_text(double ratio);

}  // namespace sluice
