#include "engine/scene/table/excerpt.hpp"

#include <fmt/format.h>

namespace sluice {

std::string excerpt(std::string_view text, std::size_t most) {
    std::string shown;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const auto c = static_cast<unsigned char>(text[at]);
        // Not within a character of several bytes.
        if (shown.size() >= most && (c & 0xc0) != 0x80) return fmt::format("{}... ({} bytes)", shown, text.size());
        shown += c < 0x20 || c == 0x7f ? fmt::format("\\x{:02x}", c) : std::string(1, text[at]);
    }
    return shown;
}

}  // namespace sluice
