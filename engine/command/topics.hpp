// Short texts for the terminal: `sluice help TOPIC`. They stand in topics/*.txt and are part of the program.
#pragma once

#include <span>
#include <string_view>

namespace sluice {

struct Topic {
    std::string_view name;
    std::string_view text;  ///< its first line says what it is about

    std::string_view title() const { return text.substr(0, text.find('\n')); }
};

/// In the order in which they are listed.
std::span<const Topic> topics();

}  // namespace sluice
