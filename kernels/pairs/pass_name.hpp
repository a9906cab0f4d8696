// What a pass over pairs is called in profiles.
#pragma once

#include <string_view>

namespace sluice {

/// Passes that do the same by different formulas, of which a scene has one, share a name.
template <class Pass>
inline constexpr std::string_view pass_name = Pass::name;

}  // namespace sluice
