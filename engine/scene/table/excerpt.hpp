#pragma once

#include <string>
#include <string_view>

namespace sluice {

/// A user's text as a message may show it: on one line, control characters as \xNN, at most so many bytes.
std::string excerpt(std::string_view text, std::size_t most = 200);

}  // namespace sluice
