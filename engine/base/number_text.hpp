// Numbers as people read them.
#pragma once

#include <string>

namespace sluice {

/// 0:07, 12:34, 1:02:03
std::string clock_text(double seconds);
/// 950, 12.3 k, 2.31 M, 1.20 G
std::string short_number(double value);
/// 950 B, 12.3 kB, 8.10 MB
std::string memory_text(double bytes);

}  // namespace sluice
