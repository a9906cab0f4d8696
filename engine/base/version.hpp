#pragma once

#include <string_view>

namespace sluice {

/// As stated in CMakeLists.txt.
std::string_view program_version();

}  // namespace sluice
