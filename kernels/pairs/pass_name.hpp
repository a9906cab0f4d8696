// The name of a pass over pairs in profiles.
#pragma once

#include <string_view>

namespace sluice {

/// Passes that do the same by different formulas share a name; a scene has only one of them.
template <class Pass>
inline constexpr std::string_view pass_name = Pass::name;

}  // namespace sluice
