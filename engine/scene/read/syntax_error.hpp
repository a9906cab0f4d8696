// What is wrong with a text that is not TOML, in words that lead to the mend.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sluice {

/// Counted from 1, as editors do.
struct TextPlace {
    std::size_t line = 1, column = 1;
};

/// "2:11: found …, expected …". `at` is where the parser gave up, and `description` what it says: the answer where
/// nothing better is known.
std::string explain_syntax_error(std::string_view text, TextPlace at, std::string_view description);

}  // namespace sluice
