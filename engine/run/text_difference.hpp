#pragma once

#include <string>
#include <string_view>

namespace sluice {

/// Lines that one text has and the other has not, as `diff` shows them: "- " in front of those of the old one, "+ " of
/// the new one, in the order of the texts. Empty if they are equal.
std::string text_difference(std::string_view before, std::string_view after);

}  // namespace sluice
