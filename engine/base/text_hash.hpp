#pragma once

#include <string>
#include <string_view>

namespace sluice {

/// FNV-1a, 64 bits, as 16 hexadecimal digits [Fowler, Noll & Vo]: tells scenes apart, keeps no secrets.
std::string text_hash(std::string_view text);

}  // namespace sluice
